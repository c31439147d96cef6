import type { Point } from "../document/formation";
import { placesAlong } from "./path";
import { clampCount, countAlong, countAround, type Spacing } from "./spacing";

/** Corners of the outline drawn for a round shape. */
const OUTLINE = 96;

/** The arc through two ends and a top, from the first end to the second; straight when it has no height. */
export interface Arc {
  readonly center: Point;
  readonly radius: number;
  /** Radians, counterclockwise from x. */
  readonly start: number;
  /** Radians, signed. */
  readonly sweep: number;
}

/** The arc over a chord along x whose top is `height` above the chord; null when that is a line. */
export function arcOver(from: Point, width: number, height: number): Arc | null {
  const half = width / 2;
  if (Math.abs(height) < 1e-9 * Math.abs(width) || half === 0) return null;
  const radius = (half ** 2 + height ** 2) / (2 * Math.abs(height));
  const center: Point = [from[0] + half, from[1] + height - Math.sign(height) * radius];
  const start = Math.atan2(from[1] - center[1], from[0] - center[0]);
  const isOver = height > 0 === width > 0;
  const angle = 2 * Math.atan2(Math.abs(half), radius - Math.abs(height));
  return { center, radius, start, sweep: isOver ? -angle : angle };
}

export function placesOnArc(arc: Arc, spacing: Spacing): Point[] {
  const length = arc.radius * Math.abs(arc.sweep);
  const count = countAlong(length, spacing);
  if (count === 1) return [pointOn(arc, 0.5)];
  const step = spacing.by === "interval" ? spacing.meters / length : 1 / (count - 1);
  return Array.from({ length: count }, (_, i) => pointOn(arc, i * step));
}

export function arcOutline(arc: Arc): Point[] {
  return Array.from({ length: OUTLINE + 1 }, (_, i) => pointOn(arc, i / OUTLINE));
}

/** Places around a circle, the first away from the audience, on to the right. */
export function placesOnCircle(center: Point, radius: number, spacing: Spacing, turn = 0): Point[] {
  const count = countAround(2 * Math.PI * radius, spacing);
  return Array.from({ length: count }, (_, i) => pointOnCircle(center, radius, (i + turn) / count));
}

export function circleOutline(center: Point, radius: number): Point[] {
  return Array.from({ length: OUTLINE + 1 }, (_, i) => pointOnCircle(center, radius, i / OUTLINE));
}

/** The inner circle of a ring, as a share of the outer. */
export const INNER_SHARE = 0.6;

/** Two circles about one center, shared out so that both are spaced alike; too few for two all stand outside. */
export function placesOnRing(center: Point, radius: number, spacing: Spacing): Point[] {
  const inner = radius * INNER_SHARE;
  if (spacing.by === "interval") {
    const outside = placesOnCircle(center, radius, spacing);
    return [...outside, ...placesOnCircle(center, inner, spacing).slice(0, Math.max(0, 5000 - outside.length))];
  }
  const count = clampCount(spacing.count);
  const within = count < 8 ? 0 : Math.round((count * INNER_SHARE) / (1 + INNER_SHARE));
  const outside = placesOnCircle(center, radius, { by: "count", count: count - within });
  return within > 0 ? [...outside, ...placesOnCircle(center, inner, { by: "count", count: within })] : outside;
}

/** The straight line that an arc without height is. */
export function placesOnChord(from: Point, width: number, spacing: Spacing): Point[] {
  return placesAlong([from, [from[0] + width, from[1]]], spacing);
}

function pointOn({ center, radius, start, sweep }: Arc, t: number): Point {
  const angle = start + sweep * t;
  return [center[0] + radius * Math.cos(angle), center[1] + radius * Math.sin(angle)];
}

function pointOnCircle(center: Point, radius: number, turn: number): Point {
  const angle = Math.PI / 2 - 2 * Math.PI * turn;
  return [center[0] + radius * Math.cos(angle), center[1] + radius * Math.sin(angle)];
}
