import type { Bounds, Camera, ScreenPoint } from "./camera";
import type { Lifts } from "./lifts";

/** Compass corners and edges scale, `rotate` turns, `lift` raises; north is up on the screen. */
export type ScaleHandle = "nw" | "n" | "ne" | "e" | "se" | "s" | "sw" | "w";
export type Handle = ScaleHandle | "rotate" | "lift";

export const SCALE_HANDLES: readonly ScaleHandle[] = ["nw", "n", "ne", "e", "se", "s", "sw", "w"];

/** CSS pixels: how far the handle to turn stands above the box, and the one to lift beside it. */
const REACH = 22;
/** How far the one to lift stands above the box that agents on one spot would have. */
const REACH_OF_SPOT = 8;

/** The frame around the selected agents: CSS pixels on the stage element. */
export interface SelectionBox {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
  /** One agent, or several on one spot: nothing to scale or to turn, and no frame is drawn. */
  readonly isSpot: boolean;
}

/** Where the selected agents stand: meters, no margin; null when none is. */
export function selectionBounds(xy: ArrayLike<number>, agents: Iterable<number>): Bounds | null {
  let minX = Number.POSITIVE_INFINITY;
  let minY = Number.POSITIVE_INFINITY;
  let maxX = Number.NEGATIVE_INFINITY;
  let maxY = Number.NEGATIVE_INFINITY;
  for (const agent of agents) {
    const x = xy[2 * agent];
    const y = xy[2 * agent + 1];
    if (x === undefined || y === undefined) continue;
    minX = Math.min(minX, x);
    maxX = Math.max(maxX, x);
    minY = Math.min(minY, y);
    maxY = Math.max(maxY, y);
  }
  return maxX >= minX ? { minX, minY, maxX, maxY } : null;
}

/** The box drawn around `bounds`, `radius + 12` px outside the agents' middles, on whole pixels' centers so that its edge is crisp. */
export function selectionBox(bounds: Bounds, camera: Camera, radius: number): SelectionBox {
  const margin = radius + 12;
  return {
    left: crisp(bounds.minX * camera.scale + camera.left - margin),
    top: crisp(camera.top - bounds.maxY * camera.scale - margin),
    right: crisp(bounds.maxX * camera.scale + camera.left + margin),
    bottom: crisp(camera.top - bounds.minY * camera.scale + margin),
    isSpot: bounds.minX === bounds.maxX && bounds.minY === bounds.maxY,
  };
}

/** The handles a box has. */
export function handlesOf(box: SelectionBox, lifts: Lifts): readonly Handle[] {
  if (box.isSpot) return lifts === "everybody" ? ["lift"] : [];
  return lifts === "nobody" ? [...SCALE_HANDLES, "rotate"] : [...SCALE_HANDLES, "rotate", "lift"];
}

/** The middle of a handle on the screen. */
export function handlePlace(box: SelectionBox, handle: Handle): ScreenPoint {
  const middleX = (box.left + box.right) / 2;
  const middleY = (box.top + box.bottom) / 2;
  if (handle === "rotate") return { x: middleX, y: box.top - REACH };
  if (handle === "lift") {
    return box.isSpot ? { x: middleX, y: box.top - REACH_OF_SPOT } : { x: box.right + REACH, y: middleY };
  }
  return {
    x: handle.includes("w") ? box.left : handle.includes("e") ? box.right : middleX,
    y: handle.includes("n") ? box.top : handle.includes("s") ? box.bottom : middleY,
  };
}

/** The one of `handles` within `reach` pixels of `at`, nearest first; null when there is none. */
export function handleAt(box: SelectionBox, handles: readonly Handle[], at: ScreenPoint, reach: number): Handle | null {
  let best: Handle | null = null;
  let nearest = reach;
  for (const handle of handles) {
    const place = handlePlace(box, handle);
    const distance = Math.hypot(place.x - at.x, place.y - at.y);
    if (distance <= nearest) {
      best = handle;
      nearest = distance;
    }
  }
  return best;
}

/** The place on the stage that stays put while `handle` scales `bounds`: the opposite corner or edge, meters. */
export function scaleAnchor(bounds: Bounds, handle: ScaleHandle): readonly [x: number, y: number] {
  const middleX = (bounds.minX + bounds.maxX) / 2;
  const middleY = (bounds.minY + bounds.maxY) / 2;
  return [
    handle.includes("w") ? bounds.maxX : handle.includes("e") ? bounds.minX : middleX,
    handle.includes("n") ? bounds.minY : handle.includes("s") ? bounds.maxY : middleY,
  ];
}

/** CSS cursor over a handle. */
export function handleCursor(handle: Handle): string {
  switch (handle) {
    case "rotate":
      return "grab";
    case "n":
    case "s":
    case "lift":
      return "ns-resize";
    case "e":
    case "w":
      return "ew-resize";
    case "nw":
    case "se":
      return "nwse-resize";
    case "ne":
    case "sw":
      return "nesw-resize";
  }
}

function crisp(value: number): number {
  return Math.round(value) + 0.5;
}
