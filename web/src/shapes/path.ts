import type { Point } from "../document/formation";
import { countAlong, countAround, type Spacing } from "./spacing";

/** A path over points, measured by its length from the first, meters. */
interface Path {
  readonly points: readonly Point[];
  /** Length from the start to each point. */
  readonly lengths: readonly number[];
  readonly total: number;
}

/** How long a path is; back to its start when it is closed. */
export function pathLength(points: readonly Point[], isClosed: boolean): number {
  return measure(isClosed ? [...points, ...points.slice(0, 1)] : points).total;
}

/** Places evenly spaced along an open path; both ends are occupied, by interval the first one. */
export function placesAlong(points: readonly Point[], spacing: Spacing): Point[] {
  const path = measure(points);
  const count = countAlong(path.total, spacing);
  if (count === 1) return [pointAt(path, spacing.by === "interval" ? 0 : path.total / 2)];
  const step = spacing.by === "interval" ? spacing.meters : path.total / (count - 1);
  return Array.from({ length: count }, (_, i) => pointAt(path, i * step));
}

/** Places evenly spaced around a closed path, the first at its start. */
export function placesAround(points: readonly Point[], spacing: Spacing): Point[] {
  const path = measure([...points, ...points.slice(0, 1)]);
  const count = countAround(path.total, spacing);
  return Array.from({ length: count }, (_, i) => pointAt(path, (i * path.total) / count));
}

/**
 * Places around a polygon with every corner occupied, and the rest shared among the edges by their length.
 *
 * With fewer places than corners they are spaced evenly instead.
 */
export function placesOnCorners(corners: readonly Point[], spacing: Spacing): Point[] {
  const ring = [...corners, ...corners.slice(0, 1)];
  const lengths = corners.map((corner, i) => distance(corner, ring[i + 1] ?? corner));
  const total = lengths.reduce((sum, length) => sum + length, 0);
  const count = countAround(total, spacing);
  if (count < corners.length) return placesAround(corners, { by: "count", count });
  const shares = shareOut(count - corners.length, lengths);
  return corners.flatMap((corner, i) => {
    const steps = (shares[i] ?? 0) + 1;
    const next = ring[i + 1] ?? corner;
    return Array.from({ length: steps }, (_, k) => between(corner, next, k / steps));
  });
}

/** Whole shares of `count` after the weights; what is left over goes where an edge is spaced widest. */
export function shareOut(count: number, weights: readonly number[]): number[] {
  const total = weights.reduce((sum, weight) => sum + weight, 0);
  const shares = weights.map((weight) => (total > 0 ? Math.floor((count * weight) / total) : 0));
  let left = count - shares.reduce((sum, share) => sum + share, 0);
  while (left > 0) {
    let widest = 0;
    const gap = (i: number) => (weights[i] ?? 0) / ((shares[i] ?? 0) + 1);
    for (let i = 1; i < weights.length; i += 1) if (gap(i) > gap(widest) * (1 + 1e-12)) widest = i;
    shares[widest] = (shares[widest] ?? 0) + 1;
    left -= 1;
  }
  return shares;
}

export function distance(a: Point, b: Point): number {
  return Math.hypot(b[0] - a[0], b[1] - a[1]);
}

export function between(a: Point, b: Point, t: number): Point {
  return [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t];
}

function measure(points: readonly Point[]): Path {
  const lengths: number[] = [];
  let total = 0;
  for (const [i, point] of points.entries()) {
    if (i > 0) total += distance(points[i - 1] ?? point, point);
    lengths.push(total);
  }
  return { points, lengths, total };
}

function pointAt({ points, lengths, total }: Path, along: number): Point {
  const wanted = Math.max(0, Math.min(total, along));
  let low = 0;
  let high = points.length - 1;
  while (low + 1 < high) {
    const middle = (low + high) >> 1;
    if ((lengths[middle] ?? 0) <= wanted) low = middle;
    else high = middle;
  }
  const [a, b] = [points[low], points[high]];
  if (!a || !b) return [0, 0];
  const span = (lengths[high] ?? 0) - (lengths[low] ?? 0);
  return between(a, b, span > 0 ? (wanted - (lengths[low] ?? 0)) / span : 0);
}
