/** Where something that opens stands to what opened it. */
export type Side = "below" | "below-end" | "above" | "right" | "outside";

const GAP = 6;
const EDGE = 8;

interface Box {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

interface Size {
  readonly width: number;
  readonly height: number;
}

/** The upper left corner of a panel beside an anchor, turned over where there is no room and kept in the window. */
export function placeFor(anchor: Box, panel: Size, window: Size, side: Side): { left: number; top: number } {
  const { left, top } = wantedFor(anchor, panel, window, side);
  return {
    left: Math.max(EDGE, Math.min(left, window.width - panel.width - EDGE)),
    top: Math.max(EDGE, Math.min(top, window.height - panel.height - EDGE)),
  };
}

function wantedFor(anchor: Box, panel: Size, window: Size, side: Side): { left: number; top: number } {
  if (side === "outside") return outsideOf(anchor, panel, window) ?? wantedFor(anchor, panel, window, "below-end");
  const below = anchor.bottom + GAP;
  const above = anchor.top - GAP - panel.height;
  const isRoomBelow = below + panel.height + EDGE <= window.height;
  const isRoomAbove = above >= EDGE;
  const left = side === "below-end" ? anchor.right - panel.width : side === "right" ? anchor.right + GAP : anchor.left;
  const vertical = side === "above" ? isRoomAbove || !isRoomBelow : !isRoomBelow && isRoomAbove;
  return { left, top: side === "right" ? anchor.top : vertical ? above : below };
}

/** To the left of an anchor, else to its right, on its height: over nothing that follows. Null where neither has room. */
function outsideOf(anchor: Box, panel: Size, window: Size): { left: number; top: number } | null {
  const top = (anchor.top + anchor.bottom - panel.height) / 2;
  const left = anchor.left - GAP - panel.width;
  if (left >= EDGE) return { left, top };
  const right = anchor.right + GAP;
  return right + panel.width + EDGE <= window.width ? { left: right, top } : null;
}

/** Puts an open popover beside its button, or as far aside as `row` reaches. */
export function placeBeside(panel: HTMLElement, anchor: HTMLElement, side: Side, row: Element = anchor): void {
  // Further right it would be measured as narrow as what is left of the window.
  panel.style.left = "0";
  const size = { width: panel.offsetWidth, height: panel.offsetHeight };
  const window = { width: innerWidth, height: innerHeight };
  const { top, bottom } = anchor.getBoundingClientRect();
  const { left, right } = row.getBoundingClientRect();
  const place = placeFor({ left, top, right, bottom }, size, window, side);
  panel.style.left = `${place.left}px`;
  panel.style.top = `${place.top}px`;
}
