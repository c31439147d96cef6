import type { Box } from "../document/box";
import type { Point } from "../document/formation";

/** A line that says why a moved thing stops where it does; `gap` is the distance it repeats, meters. */
export interface Guide {
  readonly from: Point;
  readonly to: Point;
  readonly gap: number | null;
}

/** A move with the corrections that bring it in line with its neighbors. */
export interface Guided {
  readonly by: Point;
  /** Whether x, and whether y, is in line. */
  readonly isHeld: readonly [x: boolean, y: boolean];
  readonly guides: readonly Guide[];
}

/** Only so many of the nearest agents attract: in a crowd everything is in line with something. */
const NEIGHBORS = 12;

/**
 * Holds a moved box in line with its neighbors: an edge or the middle with an agent, else a gap equal to the one beside.
 *
 * @param box of the moved agents where they came from
 * @param others places of the agents that stay
 * @param by the move as pulled, meters
 * @param reach how far the box lets itself be drawn, meters
 */
export function guideMove(box: Box, others: readonly Point[], by: Point, reach: number): Guided {
  const near = nearest(others, moved(box, by));
  const inX = alignment(box, near, by, 0, reach);
  const inY = alignment(box, near, by, 1, reach);
  // A gap counts only in a row or column that the box is in already.
  const gapX = inX === null && inY !== null ? equalGap(box, near, [by[0], inY], 0, reach) : null;
  const gapY = inY === null && inX !== null ? equalGap(box, near, [inX, by[1]], 1, reach) : null;
  const held: Point = [inX ?? gapX?.by ?? by[0], inY ?? gapY?.by ?? by[1]];
  const there = moved(box, held);
  return {
    by: held,
    isHeld: [inX !== null || gapX !== null, inY !== null || gapY !== null],
    guides: [
      ...(inX === null ? [] : alignmentLines(there, near, 0)),
      ...(inY === null ? [] : alignmentLines(there, near, 1)),
      ...(gapX?.guides ?? []),
      ...(gapY?.guides ?? []),
    ],
  };
}

type Axis = 0 | 1;

/** The move along one axis that brings an edge or the middle onto the nearest neighbor; null when none is near. */
function alignment(box: Box, near: readonly Point[], by: Point, axis: Axis, reach: number): number | null {
  return nearestMove(
    anchors(box, axis),
    near.map((other) => other[axis]),
    by[axis],
    reach,
  );
}

/** The move that brings one of `anchors` onto one of `targets` and is within `reach` of `by`, nearest first; else null. */
export function nearestMove(
  anchors: readonly number[],
  targets: readonly number[],
  by: number,
  reach: number,
): number | null {
  let best: number | null = null;
  let least = reach;
  for (const anchor of anchors) {
    for (const target of targets) {
      const off = Math.abs(target - anchor - by);
      if (off < least) {
        least = off;
        best = target - anchor;
      }
    }
  }
  return best;
}

function alignmentLines(there: Box, near: readonly Point[], axis: Axis): Guide[] {
  const across = axis === 0 ? 1 : 0;
  return anchors(there, axis).flatMap((anchor): Guide[] => {
    const met = near.filter((other) => Math.abs(other[axis] - anchor) < 1e-9);
    if (met.length === 0) return [];
    const reached = [...met.map((other) => other[across]), there.min[across], there.max[across]];
    return [line(axis, anchor, Math.min(...reached), Math.max(...reached), null)];
  });
}

/** The move along one axis that makes the gap to a neighbor equal to the one beside it, or halves the room between two. */
function equalGap(box: Box, near: readonly Point[], by: Point, axis: Axis, reach: number) {
  const across = axis === 0 ? 1 : 0;
  const there = moved(box, by);
  const row = near
    .filter((other) => other[across] >= there.min[across] - reach && other[across] <= there.max[across] + reach)
    .map((other) => other[axis])
    .sort((a, b) => a - b);
  const below = row.filter((value) => value < there.min[axis]).slice(-2);
  const above = row.filter((value) => value > there.max[axis]).slice(0, 2);
  const level = (there.min[across] + there.max[across]) / 2;
  const size = box.max[axis] - box.min[axis];
  const candidates: { readonly start: number; readonly gaps: readonly (readonly [number, number])[] }[] = [];
  const [second, first] = below.length === 2 ? below : [undefined, below[0]];
  const [next, far] = above;
  if (first !== undefined && second !== undefined) {
    const start = 2 * first - second;
    candidates.push({
      start,
      gaps: [
        [second, first],
        [first, start],
      ],
    });
  }
  if (next !== undefined && far !== undefined) {
    const end = 2 * next - far;
    candidates.push({
      start: end - size,
      gaps: [
        [end, next],
        [next, far],
      ],
    });
  }
  if (first !== undefined && next !== undefined) {
    const start = (first + next - size) / 2;
    candidates.push({
      start,
      gaps: [
        [first, start],
        [start + size, next],
      ],
    });
  }
  const offBy = (start: number) => Math.abs(start - there.min[axis]);
  const best = candidates
    .filter(({ start }) => offBy(start) < reach)
    .sort((a, b) => offBy(a.start) - offBy(b.start))[0];
  if (!best) return null;
  const guides = best.gaps.map(([from, to]) => line(across, level, from, to, to - from));
  return { by: best.start - box.min[axis], guides };
}

/** A line where `axis` has the value `at`, from one value of the other axis to another. */
function line(axis: Axis, at: number, from: number, to: number, gap: number | null): Guide {
  return axis === 0 ? { from: [at, from], to: [at, to], gap } : { from: [from, at], to: [to, at], gap };
}

function anchors({ min, max }: Box, axis: Axis): readonly number[] {
  const middle = (min[axis] + max[axis]) / 2;
  return max[axis] - min[axis] < 1e-9 ? [middle] : [min[axis], middle, max[axis]];
}

function moved({ min, max }: Box, by: Point): Box {
  return { min: [min[0] + by[0], min[1] + by[1]], max: [max[0] + by[0], max[1] + by[1]] };
}

function nearest(others: readonly Point[], { min, max }: Box): readonly Point[] {
  if (others.length <= NEIGHBORS) return others;
  const away = ([x, y]: Point) => Math.hypot(Math.max(min[0] - x, 0, x - max[0]), Math.max(min[1] - y, 0, y - max[1]));
  return others
    .map((other) => ({ other, away: away(other) }))
    .sort((a, b) => a.away - b.away)
    .slice(0, NEIGHBORS)
    .map(({ other }) => other);
}
