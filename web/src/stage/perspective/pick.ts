import type { ScreenPoint } from "../camera";

/**
 * The agent under `at`, within `slack` pixels of its body; null where there is none.
 *
 * `feet` and `heads` hold x, y in CSS pixels and the depth, three numbers an agent; `halfWidths` pixels. Of bodies
 * that cover the pointer the nearest to the eye counts, else the one that misses it least.
 */
export function bodyAt(
  feet: Float32Array,
  heads: Float32Array,
  halfWidths: Float32Array,
  at: ScreenPoint,
  slack: number,
): number | null {
  let best: number | null = null;
  let bestMiss = slack;
  let bestDepth = Number.POSITIVE_INFINITY;
  for (let agent = 0; agent < halfWidths.length; agent += 1) {
    const k = 3 * agent;
    const depth = feet[k + 2] ?? 0;
    if (depth <= 0) continue;
    const away = distanceToLine(at, feet[k] ?? 0, feet[k + 1] ?? 0, heads[k] ?? 0, heads[k + 1] ?? 0);
    const miss = Math.max(0, away - (halfWidths[agent] ?? 0));
    const isBetter = miss < bestMiss || (miss === bestMiss && depth < bestDepth);
    if (!isBetter) continue;
    best = agent;
    bestMiss = miss;
    bestDepth = depth;
  }
  return best;
}

function distanceToLine({ x, y }: ScreenPoint, ax: number, ay: number, bx: number, by: number): number {
  const dx = bx - ax;
  const dy = by - ay;
  const length = dx * dx + dy * dy;
  const t = length > 0 ? Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / length)) : 0;
  return Math.hypot(ax + t * dx - x, ay + t * dy - y);
}
