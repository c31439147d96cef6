/** Where something that opens stands to what opened it. */
export type Side = "below" | "below-end" | "above" | "right";

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
  const below = anchor.bottom + GAP;
  const above = anchor.top - GAP - panel.height;
  const isRoomBelow = below + panel.height + EDGE <= window.height;
  const isRoomAbove = above >= EDGE;
  const left = side === "below-end" ? anchor.right - panel.width : side === "right" ? anchor.right + GAP : anchor.left;
  const vertical = side === "above" ? isRoomAbove || !isRoomBelow : !isRoomBelow && isRoomAbove;
  const top = side === "right" ? anchor.top : vertical ? above : below;
  return {
    left: Math.max(EDGE, Math.min(left, window.width - panel.width - EDGE)),
    top: Math.max(EDGE, Math.min(top, window.height - panel.height - EDGE)),
  };
}

/** Puts an open popover beside its button. */
export function placeBeside(panel: HTMLElement, anchor: HTMLElement, side: Side): void {
  const size = { width: panel.offsetWidth, height: panel.offsetHeight };
  const window = { width: innerWidth, height: innerHeight };
  const place = placeFor(anchor.getBoundingClientRect(), size, window, side);
  panel.style.left = `${place.left}px`;
  panel.style.top = `${place.top}px`;
}
