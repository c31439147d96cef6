import { barycenterOf, type Formation, type Point } from "../document/formation";
import type { TravelPath } from "../document/scene";
import { type Snap, snapPoint } from "../document/snap";
import { placesAlong } from "./path";
import { smoothed } from "./stroke";

/** Pieces of the curve between two points, as drawn. */
const PIECES = 12;
/** How many points a stroke may be kept in; the fewest that are near enough. */
const COUNTS = [3, 4, 5, 6, 8, 10, 13, 17, 24] as const;
/** How far the curve through them may be from the stroke, of its length. */
const NEAR = 0.012;
/** How far a bow stands off its chord, of its length. */
const RISE = 0.25;
/** A bow from a place back to it, meters. */
const LOOP = 8;
/** Meters: a curve through a point is led there by a sum, which is exact to this at any size of a stage. */
const ROUND_OFF = 1e-9;

/**
 * The points of a path where they are followed from one barycenter to another: each as far from the straight way between those as it is
 * from that between the path's own ends, at its share of the path's length. As the engine fits them.
 */
export function followed(path: TravelPath, from: Point, to: Point): Point[] {
  const points = path.map(([x, y]): Point => [x, y]);
  const along = lengthsOf(points);
  const total = along.at(-1) || 1;
  const [first, last] = [points[0] ?? from, points.at(-1) ?? to];
  const fitted = points.map((point, k): Point => {
    const share = (along[k] ?? 0) / total;
    return [0, 1].map((axis) => {
      const [start, stop] = [from[axis as 0 | 1], to[axis as 0 | 1]];
      const straight = first[axis as 0 | 1] + (last[axis as 0 | 1] - first[axis as 0 | 1]) * share;
      return start + (stop - start) * share + point[axis as 0 | 1] - straight;
    }) as [number, number];
  });
  return [from, ...fitted.slice(1, -1), to];
}

/** The curve through points, as a fine line: a spline over the length of their chords, parabolas at its ends. */
export function curveThrough(points: readonly Point[]): Point[] {
  const distinct = points.filter((point, k) => k === 0 || distance(point, points[k - 1] ?? point) > 0);
  if (distinct.length < 3) return [...distinct];
  const knots = lengthsOf(distinct);
  const bends = ([0, 1] as const).map((axis) =>
    bendsOf(
      knots,
      distinct.map((point) => point[axis]),
    ),
  );
  const line: Point[] = [];
  for (let k = 0; k + 1 < distinct.length; k += 1) {
    const step = (knots[k + 1] ?? 0) - (knots[k] ?? 0);
    for (let piece = k === 0 ? 0 : 1; piece <= PIECES; piece += 1) {
      const b = piece / PIECES;
      const a = 1 - b;
      const of = (axis: 0 | 1) =>
        a * (distinct[k]?.[axis] ?? 0) +
        b * (distinct[k + 1]?.[axis] ?? 0) +
        (((a ** 3 - a) * (bends[axis]?.[k] ?? 0) + (b ** 3 - b) * (bends[axis]?.[k + 1] ?? 0)) * step * step) / 6;
      line.push([of(0), of(1)]);
    }
  }
  return line;
}

/** How long a line is, meters. */
export function lengthAlong(line: readonly Point[]): number {
  return lengthsOf(line).at(-1) ?? 0;
}

/** How far a line turns from its start to its end, radians, counterclockwise; whole turns count. */
export function turnAlong(line: readonly Point[]): number {
  let turn = 0;
  let last: Point | null = null;
  line.slice(1).forEach((point, k) => {
    const before = line[k] ?? point;
    const way: Point = [point[0] - before[0], point[1] - before[1]];
    if (Math.hypot(...way) === 0) return;
    if (last) turn += Math.atan2(last[0] * way[1] - last[1] * way[0], last[0] * way[0] + last[1] * way[1]);
    last = way;
  });
  return turn;
}

/** The turn that takes one formation nearest to another, radians; least squares about the barycenters. */
export function turnBetween(from: Formation, to: Formation): number {
  const [a, b] = [barycenterOf(from), barycenterOf(to)];
  let [along, across] = [0, 0];
  for (let agent = 0; agent < from.agentCount; agent += 1) {
    const [x, y] = [from.x(agent) - a[0], from.y(agent) - a[1]];
    const [u, v] = [to.x(agent) - b[0], to.y(agent) - b[1]];
    along += x * u + y * v;
    across += x * v - y * u;
  }
  return along === 0 && across === 0 ? 0 : Math.atan2(across, along);
}

/**
 * A stroke as a path: the fewest points whose curve is near it. Drawn the other way about, from the target to the source, it is turned
 * around. Null when it goes nowhere.
 */
export function pathOfStroke(stroke: readonly Point[], from: Point, to: Point, snap: Snap): Point[] | null {
  const [start, stop] = [stroke[0], stroke.at(-1)];
  if (!start || !stop || lengthAlong(stroke) === 0) return null;
  const isBack = distance(start, to) + distance(stop, from) < distance(start, from) + distance(stop, to);
  const line = smoothed(isBack ? stroke.toReversed() : stroke);
  const reach = NEAR * lengthAlong(line);
  const kept = (count: number) => placesAlong(line, { by: "count", count });
  const count = COUNTS.find((tried) => farthest(line, curveThrough(kept(tried))) <= reach) ?? COUNTS[COUNTS.length - 1];
  return settled(kept(count ?? 3), from, to, snap);
}

/** A bow from one place to another, to the left of the way; from a place back to it, a loop. */
export function bowBetween(from: Point, to: Point, snap: Snap): Point[] {
  const way: Point = [to[0] - from[0], to[1] - from[1]];
  if (Math.hypot(...way) < LOOP / 8) {
    const loop = [0, 1, 2, 3, 4, 5, 6].map((k): Point => {
      const angle = (k * Math.PI) / 3 - Math.PI / 2;
      return [from[0] + (LOOP / 2) * Math.cos(angle), from[1] + (LOOP / 2) * (1 + Math.sin(angle))];
    });
    return settled(loop, from, to, snap);
  }
  const bow = [0, 0.25, 0.5, 0.75, 1].map((share): Point => {
    const off = 4 * RISE * share * (1 - share);
    return [from[0] + way[0] * share - way[1] * off, from[1] + way[1] * share + way[0] * off];
  });
  return settled(bow, from, to, snap);
}

/** The path with a point elsewhere, or without it; its ends are the barycenters. */
export function settled(points: readonly Point[], from: Point, to: Point, snap: Snap): Point[] {
  const ends: TravelPath = points.map(([x, y]): [number, number] => [x, y]);
  return followed(ends, from, to).map((point) => snapPoint(point, snap));
}

/** Whether a line crosses itself, or comes back to one of its points; that it ends where it began is no crossing. */
export function crosses(line: readonly Point[]): boolean {
  if (returns(line)) return true;
  const turn = (a: Point, b: Point, p: Point) => (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
  const part = (a: Point, b: Point, c: Point, d: Point) => turn(a, b, c) * turn(a, b, d) < 0;
  return line.some((a, i) => {
    const b = line[i + 1];
    if (!b) return false;
    return line.slice(i + 2).some((c, k) => {
      const d = line[i + 3 + k];
      return d !== undefined && part(a, b, c, d) && part(c, d, a, b);
    });
  });
}

function returns(line: readonly Point[]): boolean {
  const isSame = (a: Point, b: Point) => distance(a, b) < ROUND_OFF;
  return line.some((a, i) => {
    const away = line.findIndex((b, j) => j > i && !isSame(a, b));
    const back = away < 0 ? -1 : line.findIndex((b, j) => j > away && isSame(a, b));
    return back > 0 && !(isSame(a, line[0] ?? a) && line.slice(back).every((b) => isSame(a, b)));
  });
}

function distance(a: Point, b: Point): number {
  return Math.hypot(b[0] - a[0], b[1] - a[1]);
}

/** How far each point is from the first, along the line. */
function lengthsOf(line: readonly Point[]): number[] {
  let length = 0;
  return line.map((point, k) => {
    length += distance(line[k - 1] ?? point, point);
    return length;
  });
}

/** The farthest that any of the points is from a line. */
function farthest(points: readonly Point[], line: readonly Point[]): number {
  const nearest = (p: Point) => Math.min(...line.slice(1).map((b, k) => toPiece(p, line[k] ?? b, b)));
  return Math.max(...points.map(nearest));
}

function toPiece(p: Point, a: Point, b: Point): number {
  const way: Point = [b[0] - a[0], b[1] - a[1]];
  const square = way[0] ** 2 + way[1] ** 2;
  const along = square > 0 ? ((p[0] - a[0]) * way[0] + (p[1] - a[1]) * way[1]) / square : 0;
  const share = Math.min(1, Math.max(0, along));
  return distance(p, [a[0] + way[0] * share, a[1] + way[1] * share]);
}

/** Second derivatives at the knots: those at both ends are those beside them. At least three knots. */
function bendsOf(knots: readonly number[], values: readonly number[]): number[] {
  const count = knots.length;
  const step = (k: number) => (knots[k + 1] ?? 0) - (knots[k] ?? 0);
  const slope = (k: number) => ((values[k + 1] ?? 0) - (values[k] ?? 0)) / step(k);
  // The first and the last row only say that ends are as what is beside them.
  const upper = [-1];
  const known = [0];
  for (let k = 1; k + 1 < count; k += 1) {
    const pivot = (step(k - 1) + step(k)) / 3 - (step(k - 1) / 6) * (upper[k - 1] ?? 0);
    upper.push(step(k) / 6 / pivot);
    known.push((slope(k) - slope(k - 1) - (step(k - 1) / 6) * (known[k - 1] ?? 0)) / pivot);
  }
  const bends = new Array<number>(count).fill(0);
  bends[count - 1] = (known[count - 2] ?? 0) / (1 + (upper[count - 2] ?? 0));
  for (let k = count - 2; k >= 0; k -= 1) bends[k] = (known[k] ?? 0) - (upper[k] ?? 0) * (bends[k + 1] ?? 0);
  return bends;
}
