import { effect, type Signal } from "@preact/signals";

const KEY = "eigenform-theme";

/** The theme the person chose stays theirs; where storage is blocked the system's serves. */
export function rememberTheme(theme: Signal<"light" | "dark" | "system">): void {
  try {
    const kept = localStorage.getItem(KEY);
    if (kept === "light" || kept === "dark") theme.value = kept;
  } catch {
    return;
  }
  effect(() => {
    const chosen = theme.value;
    try {
      if (chosen === "system") localStorage.removeItem(KEY);
      else localStorage.setItem(KEY, chosen);
    } catch {
      // Full or blocked: the choice holds until the page is closed.
    }
  });
}
