import type { Units } from "../../document/scene";
import { lengthWithUnit } from "../../document/units";
import type { Size } from "../camera";
import type { ClashFinder } from "../clashes";
import { clashReach, drawClashDistance, drawClashRing, PILLS } from "../layers/clash-mark";
import type { NamesLook } from "./names";

/** No ring is smaller, CSS pixels: from far away a clash is still seen. */
const LEAST_REACH = 9;
/** A ring leaves room about a body's feet, in radii of its mark. */
const ROOM = 1.4;
/** Seen along the ground a ring is still no line. */
const FLATTEST = 0.12;

/** The middle of the pair at hand. */
const at = new Float32Array(3);
/** Middle and reach of every ring of this frame, CSS pixels. */
let rings = new Float32Array(0);

/** Level rings about the feet of those who are too close, and the distance of the worst, as on the plan. */
export function drawClashMarks(
  context: CanvasRenderingContext2D,
  size: Size,
  look: NamesLook,
  clashes: ClashFinder,
  minimum: number,
  units: Units,
): void {
  const { palette, sight } = look;
  const flatness = Math.max(FLATTEST, -(sight.forward[2] ?? 0));
  const count = layRings(look, clashes, minimum, flatness);
  for (let ring = 3 * (count - 1); ring >= 0; ring -= 3) {
    const reach = rings[ring + 2] ?? 0;
    drawClashRing(context, palette, rings[ring] ?? 0, rings[ring + 1] ?? 0, reach, reach * flatness);
  }
  let pills = 0;
  for (let k = 0; k < clashes.count && pills < PILLS; k += 1) {
    const reach = ringAt(look, clashes, k, minimum);
    if (reach === 0) continue;
    const words = lengthWithUnit(clashes.found[k]?.distance ?? 0, units);
    if (drawClashDistance(context, palette, size, at[0] ?? 0, at[1] ?? 0, reach, words, pills)) pills += 1;
  }
}

/** Fills `rings`, worst first, and answers how many there are: a clash that lies in the ring of a worse one has none of its own. */
function layRings(look: NamesLook, clashes: ClashFinder, minimum: number, flatness: number): number {
  if (rings.length < 3 * clashes.count) rings = new Float32Array(3 * clashes.found.length);
  let count = 0;
  for (let k = 0; k < clashes.count; k += 1) {
    const reach = ringAt(look, clashes, k, minimum);
    if (reach === 0 || isInRing(at[0] ?? 0, at[1] ?? 0, flatness, count)) continue;
    rings[3 * count] = at[0] ?? 0;
    rings[3 * count + 1] = at[1] ?? 0;
    rings[3 * count + 2] = reach;
    count += 1;
  }
  return count;
}

function isInRing(x: number, y: number, flatness: number, count: number): boolean {
  for (let ring = 0; ring < 3 * count; ring += 3) {
    const reach = rings[ring + 2] ?? 0;
    if (Math.hypot(x - (rings[ring] ?? 0), (y - (rings[ring + 1] ?? 0)) / flatness) < reach) return true;
  }
  return false;
}

/** Fills `at` with the middle of the `k`-th clash; answers how far its ring reaches, 0 behind the eye. */
function ringAt({ bodies, sight }: NamesLook, clashes: ClashFinder, k: number, minimum: number): number {
  const { place, radius, shares } = bodies;
  const { a = 0, b = 0, distance = 0 } = clashes.found[k] ?? {};
  const middle = (axis: number) => ((place[3 * a + axis] ?? 0) + (place[3 * b + axis] ?? 0)) / 2;
  sight.projectInto(middle(0), middle(1), middle(2), at, 0);
  const depth = at[2] ?? 0;
  if (depth === 0) return 0;
  const feet = radius * Math.max(shares[a] ?? 1, shares[b] ?? 1);
  return Math.max(LEAST_REACH, (clashReach(minimum, distance, ROOM * feet) * sight.focal) / depth);
}
