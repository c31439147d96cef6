import type { Action } from "./actions";
import { useStudio } from "./studio";

/** An action and whether it can run now. */
export function useAction(id: string): { readonly action: Action; readonly isEnabled: boolean } {
  const action = useStudio().actions.get(id);
  return { action, isEnabled: action.isEnabled?.value ?? true };
}

export const isMac = typeof navigator !== "undefined" && /Mac|iPhone|iPad/.test(navigator.userAgent);

const ARROWS: Readonly<Record<string, string>> = { Left: "←", Right: "→", Up: "↑", Down: "↓" };

/** A shortcut as the person's keyboard spells it: `Ctrl+Z`, or `⌘Z` on a Mac. */
export function keyName(keys: string): string {
  const shown = keys.replace(/Arrow(\w+)/, (name, way: string) => ARROWS[way] ?? name);
  if (!isMac) return shown;
  return shown.replace("Ctrl+", "⌘").replace("Shift+", "⇧").replace("Alt+", "⌥");
}

/** A shortcut as `aria-keyshortcuts` wants it. */
export function keyShortcuts(keys: readonly string[]): string | undefined {
  if (keys.length === 0) return undefined;
  return keys.map((key) => key.replace("Ctrl", isMac ? "Meta" : "Control")).join(" ");
}
