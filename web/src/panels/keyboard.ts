import type { Actions } from "./actions";
import { isPressed } from "./key-match";

export interface KeyboardParts {
  readonly actions: Actions;
  readonly isMac: boolean;
  /** Whether a key is for a dialog that was asked for and is not there yet. */
  typeAhead(key: string): boolean;
  /** Space goes down: the stage pans while it is held. */
  holdSpace(): void;
  /** Space goes up: whether it was held to pan, so that it does not play. */
  releaseSpace(): boolean;
}

/** The browser brings these as events of their own, with the clipboard in hand. */
const BY_THE_BROWSER: ReadonlySet<string> = new Set(["copy", "paste"]);

/** What a text field does itself. */
const EDITS_TEXT: ReadonlySet<string> = new Set(["undo", "redo", "select-all", "copy", "paste"]);

/** Dispatches keys to actions: what has the focus comes first. Answers how to stop. */
export function attachKeyboard(page: Window, parts: KeyboardParts): () => void {
  let isSpaceHeld = false;

  function onKeyDown(event: KeyboardEvent): void {
    if (event.defaultPrevented || event.isComposing || isInDialog(event.target)) return;
    if (parts.typeAhead(event.key)) {
      if (event.key.length === 1) event.preventDefault();
      return;
    }
    if (event.code === "Space" && !event.ctrlKey && !event.metaKey && !event.altKey) {
      if (hasOwnPress(event.target)) return;
      event.preventDefault();
      if (!event.repeat) {
        isSpaceHeld = true;
        parts.holdSpace();
      }
      return;
    }
    const action = parts.actions.all.find(({ keys }) => keys.some((key) => isPressed(event, key, parts.isMac)));
    if (!action || BY_THE_BROWSER.has(action.id) || isOff(action.id, event)) return;
    event.preventDefault();
    if (action.isEnabled?.peek() ?? true) action.run();
  }

  function onKeyUp(event: KeyboardEvent): void {
    if (event.code !== "Space" || !isSpaceHeld) return;
    isSpaceHeld = false;
    if (!parts.releaseSpace()) parts.actions.get("play").run();
  }

  function onBlur(): void {
    if (isSpaceHeld) parts.releaseSpace();
    isSpaceHeld = false;
  }

  page.addEventListener("keydown", onKeyDown);
  page.addEventListener("keyup", onKeyUp);
  page.addEventListener("blur", onBlur);
  return () => {
    page.removeEventListener("keydown", onKeyDown);
    page.removeEventListener("keyup", onKeyUp);
    page.removeEventListener("blur", onBlur);
  };
}

/** Whether what has the focus keeps a key for itself. */
function isOff(id: string, event: KeyboardEvent): boolean {
  const isCommand = event.ctrlKey || event.metaKey;
  if (isTextField(event.target)) return !isCommand || EDITS_TEXT.has(id);
  if (isCommand) return false;
  if (event.key === "Enter" && hasOwnPress(event.target)) return true;
  if (isWithin(event.target, "[role=grid]")) return true;
  const steered = "input, select, [role=listbox], [role=slider], [role=radiogroup]";
  // Arrows go from tool to tool; Page Up and Page Down do not.
  if (isWithin(event.target, steered)) return /^(Arrow|Home|End|Page|Delete|Backspace)/.test(event.key);
  return isWithin(event.target, "[role=toolbar]") && /^(Arrow|Home|End|Delete|Backspace)/.test(event.key);
}

export function isTextField(target: EventTarget | null): boolean {
  if (!isWithin(target, "input, textarea, select, [contenteditable]")) return false;
  return !isWithin(target, "input[type=range], input[type=checkbox], input[type=radio], input[type=button]");
}

/** A control that has the focus is pressed by Space and Enter, a text field takes them as its own. */
function hasOwnPress(target: EventTarget | null): boolean {
  const controls = "button, summary, a[href], select, input, [role=button], [role=option], [role=switch], [role=grid]";
  return isTextField(target) || isWithin(target, controls);
}

function isInDialog(target: EventTarget | null): boolean {
  return isWithin(target, "dialog, [popover]");
}

function isWithin(target: EventTarget | null, selector: string): boolean {
  return target instanceof Element && target.closest(selector) !== null;
}
