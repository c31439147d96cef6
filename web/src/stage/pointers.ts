import type { ScreenPoint } from "./camera";

/** Wheel pixels that double the scale. */
const WHEEL_DOUBLING = 400;
/** A pinch on a trackpad turns the wheel by much smaller steps. */
const PINCH_DOUBLING = 70;
/** Pixels a line of a mouse wheel counts for. */
const LINE = 16;

/** Where an event is on an element, CSS pixels. */
export function screenOn(element: Element, event: MouseEvent): ScreenPoint {
  const box = element.getBoundingClientRect();
  return { x: event.clientX - box.left, y: event.clientY - box.top };
}

/** How far a wheel was turned either way, CSS pixels whatever it counts in. */
export function wheelTurn({ deltaX, deltaY, deltaMode }: WheelEvent): { readonly dx: number; readonly dy: number } {
  const unit = deltaMode === WheelEvent.DOM_DELTA_PIXEL ? 1 : LINE;
  return { dx: deltaX * unit, dy: deltaY * unit };
}

/** By how much a turn of the wheel zooms; with Ctrl or Cmd it is a pinch on a trackpad. */
export function wheelZoom(event: WheelEvent): number {
  return 2 ** (-wheelTurn(event).dy / (event.ctrlKey || event.metaKey ? PINCH_DOUBLING : WHEEL_DOUBLING));
}

/** What two fingers did: their middle went from one place to another, and they are so many times as far apart. */
export interface Pinch {
  readonly from: ScreenPoint;
  readonly to: ScreenPoint;
  readonly spread: number;
}

/** Fingers on an element. */
export interface Fingers {
  readonly count: number;
  put(id: number, at: ScreenPoint): void;
  /** A finger that lies there moved: one at a time, the middle of two goes half its way. Null with fewer than two. */
  pinch(id: number, to: ScreenPoint): Pinch | null;
  lift(id: number): void;
}

export function createFingers(): Fingers {
  const places = new Map<number, ScreenPoint>();
  return {
    get count() {
      return places.size;
    },
    put: (id, at) => void places.set(id, at),
    pinch(id, to) {
      const before = places.get(id);
      if (!before) return null;
      places.set(id, to);
      const still = [...places].find(([other]) => other !== id)?.[1];
      if (!still) return null;
      const middle = (moving: ScreenPoint) => ({ x: (moving.x + still.x) / 2, y: (moving.y + still.y) / 2 });
      const spread = distance(to, still) / distance(before, still);
      return { from: middle(before), to: middle(to), spread: Number.isFinite(spread) && spread > 0 ? spread : 1 };
    },
    lift: (id) => void places.delete(id),
  };
}

function distance(a: ScreenPoint, b: ScreenPoint): number {
  return Math.hypot(a.x - b.x, a.y - b.y);
}
