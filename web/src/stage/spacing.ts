import type { Formation } from "../document/formation";
import type { Track } from "../document/scene";

/** Screen spacing above which nothing gets larger or clearer; stands in for a lone agent's missing neighbor, too. */
const WIDEST = 400;

/** Seconds before and after a keyframe over which discs change from one transition's size to the next's. */
const CHANGEOVER = 0.25;

const known = new WeakMap<Formation, number>();

/** Median distance to the nearest other agent, meters; infinite when everybody is alone or stands on one spot. */
export function neighborSpacing(formation: Formation): number {
  let spacing = known.get(formation);
  if (spacing === undefined) {
    spacing = medianNearest(formation.xy);
    known.set(formation, spacing);
  }
  return spacing;
}

/** Spacing that holds for a whole transition, so that discs do not breathe: the tighter keyframe's, meters. */
export function transitionSpacing(track: Track, segment: number): number {
  const from = track.keyframes[segment];
  const to = track.keyframes[segment + 1];
  return Math.min(
    from ? neighborSpacing(from.positions) : Number.POSITIVE_INFINITY,
    to ? neighborSpacing(to.positions) : Number.POSITIVE_INFINITY,
  );
}

/** Spacing at `time` in scene seconds, meters: a transition's own, easing to the next one's around a keyframe. */
export function spacingAt(track: Track, time: number): number {
  const count = track.keyframes.length;
  let segment = 0;
  while (segment < count - 1 && time >= (track.keyframes[segment + 1]?.time ?? 0) - CHANGEOVER) segment += 1;
  // `segment` is now the last keyframe whose changeover has begun.
  const before = Math.max(segment - 1, 0);
  const after = Math.min(segment, Math.max(count - 2, 0));
  const later = transitionSpacing(track, after);
  if (before === after) return later;
  const earlier = transitionSpacing(track, before);
  const keyframe = track.keyframes[segment];
  const start = (keyframe?.time ?? 0) - CHANGEOVER;
  const length = 2 * CHANGEOVER + (keyframe?.hold ?? 0);
  const share = smoothstep(0, 1, (time - start) / length);
  if (share >= 1 || !Number.isFinite(earlier) || !Number.isFinite(later)) return later;
  return earlier + (later - earlier) * share;
}

/** `s`, the spacing on the screen that decides every detail of the drawing, CSS pixels. */
export function screenSpacing(spacing: number, scale: number): number {
  return Math.min(spacing * scale, WIDEST);
}

/** Radius of an agent's disc, CSS pixels, from the spacing on the screen. */
export function discRadius(spacing: number): number {
  return clamp(0.31 * spacing, 1.7, 11);
}

/** How far a detail has appeared between two spacings: 0 below `from`, 1 above `to`, smooth between. */
export function fade(spacing: number, from: number, to: number): number {
  return smoothstep(from, to, spacing);
}

export function clamp(value: number, low: number, high: number): number {
  return Math.min(high, Math.max(low, value));
}

export function smoothstep(from: number, to: number, value: number): number {
  const t = clamp((value - from) / (to - from), 0, 1);
  return t * t * (3 - 2 * t);
}

function medianNearest(xy: Float64Array): number {
  const count = xy.length / 2;
  if (count < 2) return Number.POSITIVE_INFINITY;
  // Sweeping in the order of x, a neighbor further away in x alone than the best so far ends the search.
  const order = Uint32Array.from({ length: count }, (_, agent) => agent).sort(
    (a, b) => (xy[2 * a] ?? 0) - (xy[2 * b] ?? 0),
  );
  const nearest = new Float64Array(count);
  for (let rank = 0; rank < count; rank += 1) {
    nearest[rank] = Math.sqrt(Math.min(nearestSquared(xy, order, rank, -1), nearestSquared(xy, order, rank, 1)));
  }
  nearest.sort();
  // Agents on one spot say nothing about how much room a disc has.
  const first = nearest.findIndex((distance) => distance > 1e-6);
  if (first < 0) return Number.POSITIVE_INFINITY;
  return nearest[first + ((count - first) >> 1)] ?? Number.POSITIVE_INFINITY;
}

function nearestSquared(xy: Float64Array, order: Uint32Array, rank: number, direction: 1 | -1): number {
  const agent = order[rank] ?? 0;
  const x = xy[2 * agent] ?? 0;
  const y = xy[2 * agent + 1] ?? 0;
  let best = Number.POSITIVE_INFINITY;
  for (let other = rank + direction; other >= 0 && other < order.length; other += direction) {
    const candidate = order[other] ?? 0;
    const dx = (xy[2 * candidate] ?? 0) - x;
    if (dx * dx >= best) break;
    const dy = (xy[2 * candidate + 1] ?? 0) - y;
    best = Math.min(best, dx * dx + dy * dy);
  }
  return best;
}
