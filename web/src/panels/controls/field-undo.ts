import type { Actions } from "../actions";

/** Undo and redo in a field nobody is typing into are those of the scene. Whether the key was one of them. */
export function undidScene(event: KeyboardEvent, actions: Actions): boolean {
  if (!(event.ctrlKey || event.metaKey) || event.altKey) return false;
  const key = event.key.toLowerCase();
  const id = key === "y" || (key === "z" && event.shiftKey) ? "redo" : key === "z" ? "undo" : null;
  if (!id) return false;
  event.preventDefault();
  const action = actions.get(id);
  if (action.isEnabled?.peek() ?? true) action.run();
  return true;
}
