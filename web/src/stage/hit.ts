import type { Point } from "../document/formation";
import type { Camera, ScreenPoint } from "./camera";

/** As `PointerEvent.pointerType` says; anything else is a mouse. */
export type PointerKind = "mouse" | "pen" | "touch" | (string & {});

/** How far from an agent's middle a pointer still means it, CSS pixels: a fingertip covers 22. */
export function agentReach(radius: number, pointer: PointerKind): number {
  return pointer === "touch" ? Math.max(radius, 22) : Math.max(radius + 2, 6);
}

/** How far from a tie's line, CSS pixels. */
export function tieReach(pointer: PointerKind): number {
  return pointer === "touch" ? 14 : 5;
}

/** How far from a handle's middle, CSS pixels. */
export function handleReach(pointer: PointerKind): number {
  return pointer === "touch" ? 22 : 9;
}

/** The agent nearest to `at` within `reach` pixels; of equally near ones the last, which is drawn on top. `xy` in meters. */
export function agentAt(xy: ArrayLike<number>, camera: Camera, at: ScreenPoint, reach: number): number | null {
  let best: number | null = null;
  let nearest = reach * reach;
  for (let agent = 0; 2 * agent + 1 < xy.length; agent += 1) {
    const dx = (xy[2 * agent] ?? 0) * camera.scale + camera.left - at.x;
    const dy = camera.top - (xy[2 * agent + 1] ?? 0) * camera.scale - at.y;
    const distance = dx * dx + dy * dy;
    if (distance <= nearest) {
      best = agent;
      nearest = distance;
    }
  }
  return best;
}

/**
 * Which tie of `pairs` (a0, b0, a1, b1, …) passes nearest to `at` within `reach` pixels.
 *
 * Answers the tie's index, null when there is none.
 */
export function tieAt(
  pairs: ArrayLike<number>,
  xy: ArrayLike<number>,
  camera: Camera,
  at: ScreenPoint,
  reach: number,
): number | null {
  const x = (at.x - camera.left) / camera.scale;
  const y = (camera.top - at.y) / camera.scale;
  let best: number | null = null;
  let nearest = (reach / camera.scale) ** 2;
  for (let tie = 0; 2 * tie + 1 < pairs.length; tie += 1) {
    const a = 2 * (pairs[2 * tie] ?? 0);
    const b = 2 * (pairs[2 * tie + 1] ?? 0);
    const distance = squaredToLine(x, y, xy[a] ?? 0, xy[a + 1] ?? 0, xy[b] ?? 0, xy[b + 1] ?? 0);
    if (distance <= nearest) {
      best = tie;
      nearest = distance;
    }
  }
  return best;
}

/** Agents inside the rectangle between two places of the stage, its edge included, in order. */
export function agentsWithin(xy: ArrayLike<number>, from: Point, to: Point): number[] {
  const minX = Math.min(from[0], to[0]);
  const maxX = Math.max(from[0], to[0]);
  const minY = Math.min(from[1], to[1]);
  const maxY = Math.max(from[1], to[1]);
  const inside: number[] = [];
  for (let agent = 0; 2 * agent + 1 < xy.length; agent += 1) {
    const x = xy[2 * agent] ?? Number.NaN;
    const y = xy[2 * agent + 1] ?? Number.NaN;
    if (x >= minX && x <= maxX && y >= minY && y <= maxY) inside.push(agent);
  }
  return inside;
}

function squaredToLine(x: number, y: number, ax: number, ay: number, bx: number, by: number): number {
  const dx = bx - ax;
  const dy = by - ay;
  const length = dx * dx + dy * dy;
  const t = length > 0 ? Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / length)) : 0;
  return (ax + t * dx - x) ** 2 + (ay + t * dy - y) ** 2;
}
