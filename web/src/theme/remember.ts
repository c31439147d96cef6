import { effect, type Signal } from "@preact/signals";

/** The theme the person chose stays theirs; where storage is blocked the system's serves. */
export function rememberTheme(theme: Signal<"light" | "dark" | "system">): void {
  remember("eigenform-theme", theme, ["light", "dark", "system"]);
}

/** Whether the timeline reads seconds or counts, which is a matter of who looks and not of the scene. */
export function rememberRuler(ruler: Signal<"seconds" | "counts">): void {
  remember("eigenform-ruler", ruler, ["seconds", "counts"]);
}

/** Takes over what was chosen last, and keeps what is chosen from now on; the value at first need not be kept. */
function remember<T extends string>(key: string, choice: Signal<T>, choices: readonly T[]): void {
  const usual = choice.peek();
  try {
    const kept = localStorage.getItem(key);
    choice.value = choices.find((value) => value === kept) ?? usual;
  } catch {
    return;
  }
  effect(() => {
    const chosen = choice.value;
    try {
      if (chosen === usual) localStorage.removeItem(key);
      else localStorage.setItem(key, chosen);
    } catch {
      // Full or blocked: the choice holds until the page is closed.
    }
  });
}
