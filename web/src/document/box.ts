import type { Formation, Point } from "./formation";

/** An upright rectangle, meters. */
export interface Box {
  readonly min: Point;
  readonly max: Point;
}

/** The smallest box around some agents; null for none. */
export function boxOf(formation: Formation, agents: Iterable<number>): Box | null {
  return boxAround(Array.from(agents, (agent) => formation.point(agent)));
}

export function boxAround(points: readonly Point[]): Box | null {
  if (points.length === 0) return null;
  let [left, bottom, right, top] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const [x, y] of points) {
    left = Math.min(left, x);
    right = Math.max(right, x);
    bottom = Math.min(bottom, y);
    top = Math.max(top, y);
  }
  return { min: [left, bottom], max: [right, top] };
}

export function centerOf({ min, max }: Box): Point {
  return [(min[0] + max[0]) / 2, (min[1] + max[1]) / 2];
}

export function contains({ min, max }: Box, [x, y]: Point): boolean {
  return x >= min[0] && x <= max[0] && y >= min[1] && y <= max[1];
}
