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

/** Between the selection box and the bar, CSS pixels. */
const GAP = 14;
/** The rotate handle stands this far above the box. */
const HANDLE = 30;
const EDGE = 12;
/** A sheet is taken hold of a little above its edge, too. */
const OVER_A_SHEET = 28;
/** The rail at the left and the pills at the top and bottom keep their place. */
const INSET = { left: 64, top: 52, bottom: 56 } as const;
/** On a phone the tools are at the foot of the stage. */
const PHONE = 640;
const INSET_ON_A_PHONE = { left: EDGE, top: EDGE, bottom: 72 } as const;

/**
 * Where the bar goes: below the box, above it when there is no room, and inside the stage when the box is not.
 *
 * @param covered pixels of the stage that something else lies over, from below
 */
export function placeBar(
  box: Box,
  bar: Size,
  stage: Size,
  covered = 0,
): { readonly left: number; readonly top: number } {
  const inset = stage.width <= PHONE ? INSET_ON_A_PHONE : INSET;
  const below = box.bottom + GAP;
  const above = box.top - HANDLE - bar.height;
  const lowest = stage.height - Math.max(inset.bottom, covered + OVER_A_SHEET) - bar.height;
  const top = below <= lowest ? below : above >= inset.top ? above : lowest;
  const middle = (box.left + box.right) / 2 - bar.width / 2;
  return {
    left: Math.round(clamp(middle, inset.left, stage.width - EDGE - bar.width)),
    top: Math.round(clamp(top, inset.top, lowest)),
  };
}

function clamp(value: number, low: number, high: number): number {
  return Math.max(Math.min(low, high), Math.min(value, high));
}
