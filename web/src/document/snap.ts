import type { Point } from "./formation";
import { mainTrack, type Scene } from "./scene";

/** The lattice gestures snap to: multiples of `meters / parts`. Kept as a fraction so that 7 cm is 0.07 exactly. */
export interface Snap {
  readonly meters: number;
  readonly parts: number;
}

/** Links keep multiples of one of these two exactly: a centimeter, and two marching steps in 64 parts (18 mm). */
export const CENTIMETER: Snap = { meters: 1, parts: 100 };
export const FIELD_GRID: Snap = { meters: 1.143, parts: 64 };

/** A place this far off the lattice is on it, meters: what a link calls exact. */
const ON_LATTICE = 1e-6;

/** The lattice of a scene: what its places already lie on, else what its backdrop suggests. */
export function snapOf(scene: Scene): Snap {
  const isField = scene.stage.backdrop === "football-college" || scene.stage.backdrop === "football-hs";
  const [first, second] = isField ? [FIELD_GRID, CENTIMETER] : [CENTIMETER, FIELD_GRID];
  const formations = mainTrack(scene).keyframes.map((keyframe) => keyframe.positions.xy);
  const lies = (snap: Snap) => formations.every((xy) => xy.every((value) => isOn(value, snap)));
  return !lies(first) && lies(second) ? second : first;
}

/** How far arrow keys move agents, meters: a decimeter and a meter, or a quarter and a whole marching step. */
export function nudgeSteps(scene: Scene): { readonly near: number; readonly far: number } {
  return snapOf(scene) === FIELD_GRID ? { near: 1.143 / 8, far: 1.143 / 2 } : { near: 0.1, far: 1 };
}

export function snapValue(value: number, snap: Snap): number {
  // Adding zero makes a minus zero plain.
  return (Math.round((value * snap.parts) / snap.meters) * snap.meters) / snap.parts + 0;
}

export function snapPoint([x, y]: Point, snap: Snap): Point {
  return [snapValue(x, snap), snapValue(y, snap)];
}

/** Places on the lattice, as distinct as they came: where two would fall together, the later one stays off it. */
export function snapApart(places: readonly Point[], snap: Snap): Point[] {
  const taken = new Set<string>();
  return places.map((place) => {
    const snapped = snapPoint(place, snap);
    const key = `${snapped[0]},${snapped[1]}`;
    if (taken.has(key)) return place;
    taken.add(key);
    return snapped;
  });
}

function isOn(value: number, snap: Snap): boolean {
  return Math.abs(value - snapValue(value, snap)) <= ON_LATTICE;
}
