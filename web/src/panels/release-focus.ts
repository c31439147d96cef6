/**
 * Lets go of the control that was pressed, so that keys reach the tools: Enter would press it again. Tab goes on from
 * where it was. A dialog keeps its focus.
 */
export function releaseFocus(): void {
  const held = document.activeElement;
  if (held instanceof HTMLElement && !held.closest("dialog")) held.blur();
}
