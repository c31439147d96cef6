import type { Point } from "../document/formation";
import { type Effort, placesInside } from "./fill";
import { distance, pathLength, placesAlong, placesAround } from "./path";
import type { Spacing } from "./spacing";

/** What becomes of a stroke: spaced along it, spaced around it when it is closed, or filling what it encloses. */
export type StrokeKind = "open" | "outline" | "filled";

/** A stroke counts as closed when it ends near its start: within `reach` meters, having gone well beyond it. */
export function isClosedStroke(stroke: readonly Point[], reach: number): boolean {
  const [first, last] = [stroke[0], stroke.at(-1)];
  if (!first || !last || stroke.length < 4) return false;
  const furthest = stroke.reduce((most, point) => Math.max(most, distance(first, point)), 0);
  return distance(first, last) <= reach && furthest > 2 * reach;
}

export function strokePlaces(
  stroke: readonly Point[],
  kind: StrokeKind,
  spacing: Spacing,
  effort: Effort = "full",
): Point[] {
  if (kind === "open") return placesAlong(stroke, spacing);
  return kind === "filled" ? placesInside(stroke, spacing, effort) : placesAround(stroke, spacing);
}

/** A stroke with a further point; a trembling hand adds none until it has gone `step` meters. */
export function extended(stroke: readonly Point[], point: Point, step: number): readonly Point[] {
  const last = stroke.at(-1);
  return last && distance(last, point) < step ? stroke : [...stroke, point];
}

/** A stroke without the tremble of the hand: each point moves to the mean of its neighbors, the ends stay. */
export function smoothed(stroke: readonly Point[], rounds = 2): readonly Point[] {
  let path = stroke;
  for (let round = 0; round < rounds; round += 1) {
    const now = path;
    path = now.map((point, i): Point => {
      const [before, after] = [now[i - 1], now[i + 1]];
      if (!before || !after) return point;
      return [(before[0] + 2 * point[0] + after[0]) / 4, (before[1] + 2 * point[1] + after[1]) / 4];
    });
  }
  return path;
}

/** Whether a stroke is long enough to be meant as one, meters. */
export function isMeant(stroke: readonly Point[], least: number): boolean {
  return stroke.length > 1 && pathLength(stroke, false) >= least;
}
