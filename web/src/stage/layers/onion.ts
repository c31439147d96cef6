import type { Frame } from "../frame";
import { clamp, fade } from "../spacing";

/** Where the agents come from, translucent discs; `gone` leave no trace. `xy` in meters. */
export function drawGhosts(
  context: CanvasRenderingContext2D,
  frame: Frame,
  xy: Float64Array,
  gone: readonly number[],
): void {
  const alpha = frame.palette.onionAlpha * fade(frame.spacing, 3, 7);
  if (alpha < 0.004) return;
  const { radius } = frame;
  const isGone = new Set(gone);
  context.globalAlpha = alpha;
  for (const { color, agents } of frame.cast.paints) {
    context.fillStyle = color;
    for (const agent of agents) {
      const x = frame.screenX(xy[2 * agent] ?? 0);
      const y = frame.screenY(xy[2 * agent + 1] ?? 0);
      if (isGone.has(agent) || !frame.sees(x, y, radius)) continue;
      context.beginPath();
      context.arc(x, y, radius, 0, 2 * Math.PI);
      context.fill();
    }
  }
  context.globalAlpha = 1;
}

/** Where the agents go, rings; `gone` leave no trace. `xy` in meters. */
export function drawTargets(
  context: CanvasRenderingContext2D,
  frame: Frame,
  xy: Float64Array,
  gone: readonly number[],
): void {
  const alpha = 0.5 * fade(frame.spacing, 7, 9);
  if (alpha === 0) return;
  const { radius } = frame;
  const isGone = new Set(gone);
  const width = clamp(0.16 * radius, 0.75, 1.25);
  context.globalAlpha = alpha;
  context.lineWidth = width;
  for (const { color, agents } of frame.cast.paints) {
    context.strokeStyle = color;
    context.beginPath();
    for (const agent of agents) {
      const x = frame.screenX(xy[2 * agent] ?? 0);
      const y = frame.screenY(xy[2 * agent + 1] ?? 0);
      if (isGone.has(agent) || !frame.sees(x, y, radius)) continue;
      context.moveTo(x + radius - width / 2, y);
      context.arc(x, y, radius - width / 2, 0, 2 * Math.PI);
    }
    context.stroke();
  }
  context.globalAlpha = 1;
}
