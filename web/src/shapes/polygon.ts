import { type Box, boxAround } from "../document/box";
import type { Point } from "../document/formation";

/** Whether a place is inside a closed path; where the path crosses itself, all it winds around is inside. */
export function isInside(polygon: readonly Point[], [x, y]: Point): boolean {
  let turns = 0;
  for (const [i, [ax, ay]] of polygon.entries()) {
    const [bx, by] = polygon[(i + 1) % polygon.length] ?? [ax, ay];
    const side = (bx - ax) * (y - ay) - (x - ax) * (by - ay);
    if (ay <= y && by > y && side > 0) turns += 1;
    if (ay > y && by <= y && side < 0) turns -= 1;
  }
  return turns !== 0;
}

/** A region cut into equal squares: the middle of each that lies inside, row by row. */
export interface Raster {
  readonly middles: readonly Point[];
  /** Side of a square, meters. */
  readonly side: number;
}

/** The region inside a closed path in about `count` squares, at least that many; null when it has no area. */
export function rasterOf(polygon: readonly Point[], count: number): Raster | null {
  const box = boxAround(polygon);
  if (!box) return null;
  const [width, depth] = [box.max[0] - box.min[0], box.max[1] - box.min[1]];
  let side = Math.sqrt((width * depth) / count);
  // A thin or winding region fills little of its box: finer squares until there are enough.
  for (let tries = 0; tries < 12 && side > 0; tries += 1) {
    const middles = middlesInside(polygon, box, side);
    if (middles.length >= count) return { middles, side };
    side *= Math.sqrt(Math.max(0.05, (middles.length / count) * 0.98));
    if ((width * depth) / side ** 2 > 400 * count) return null;
  }
  return null;
}

function middlesInside(polygon: readonly Point[], { min, max }: Box, side: number): Point[] {
  const middles: Point[] = [];
  for (let y = min[1] + side / 2; y < max[1]; y += side) {
    const crossings = crossingsAt(polygon, y);
    let turns = 0;
    let next = 0;
    for (let x = min[0] + side / 2; x < max[0]; x += side) {
      while (next < crossings.length && (crossings[next]?.x ?? 0) <= x) {
        turns += crossings[next]?.turn ?? 0;
        next += 1;
      }
      if (turns !== 0) middles.push([x, y]);
    }
  }
  return middles;
}

function crossingsAt(polygon: readonly Point[], y: number): { readonly x: number; readonly turn: number }[] {
  const crossings: { readonly x: number; readonly turn: number }[] = [];
  for (const [i, [ax, ay]] of polygon.entries()) {
    const [bx, by] = polygon[(i + 1) % polygon.length] ?? [ax, ay];
    if (ay <= y === by <= y) continue;
    crossings.push({ x: ax + ((bx - ax) * (y - ay)) / (by - ay), turn: ay <= y ? 1 : -1 });
  }
  return crossings.sort((a, b) => a.x - b.x);
}
