/** What a key event says, as `KeyboardEvent` spells it. */
export interface KeyPress {
  readonly key: string;
  /** The key's place on a US keyboard. */
  readonly code: string;
  readonly ctrlKey: boolean;
  readonly metaKey: boolean;
  readonly shiftKey: boolean;
  readonly altKey: boolean;
}

/** Whether a press is a shortcut of the table: `Ctrl+Shift+Z`, `?`, `Shift+1`. */
export function isPressed(press: KeyPress, keys: string, isMac: boolean): boolean {
  const parts = keys === "+" ? ["+"] : keys.split("+");
  const key = parts.at(-1) ?? "";
  const modifiers = parts.slice(0, -1);
  const command = isMac ? press.metaKey : press.ctrlKey;
  const other = isMac ? press.ctrlKey : press.metaKey;
  if (other || press.altKey || command !== modifiers.includes("Ctrl")) return false;
  // A sign such as ? is wherever the keyboard has it, with Shift or without.
  const isSign = key.length === 1 && !/[A-Z0-9]/.test(key);
  if (!isSign && press.shiftKey !== modifiers.includes("Shift")) return false;
  return isKey(press, key);
}

function isKey({ key, code }: KeyPress, wanted: string): boolean {
  if (wanted === "Space") return key === " " || code === "Space";
  if (/^[0-9]$/.test(wanted)) return code === `Digit${wanted}`;
  if (/^[A-Z]$/.test(wanted)) {
    // A keyboard without Latin letters is read by place.
    const isLatin = /^[a-z]$/i.test(key);
    return isLatin ? key.toUpperCase() === wanted : code === `Key${wanted}`;
  }
  return key === wanted;
}
