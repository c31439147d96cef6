import type { Frame } from "../frame";
import { traceOfGone } from "../presence";
import { clamp } from "../spacing";

/**
 * Who is absent from a formation: a hollow, broken disc where they leave to and come from. On the way it takes the place
 * of a disc as that fades; whoever is on neither end fades with the departure and comes with the arrival.
 *
 * @param share of the way, null while a formation stands
 */
export function drawAbsent(context: CanvasRenderingContext2D, frame: Frame, share: number | null): void {
  const { presence, isGone, points, radius, cast } = frame;
  const ofGone = traceOfGone(share);
  const width = clamp(0.18 * radius, 1, 1.75);
  context.lineWidth = width;
  context.setLineDash([Math.max(1.5, 0.45 * radius), Math.max(1.5, 0.35 * radius)]);
  for (let agent = 0; agent < frame.agentCount; agent += 1) {
    const missing = isGone?.[agent] ? ofGone : 1 - (presence?.[agent] ?? 1);
    const x = points[2 * agent] ?? 0;
    const y = points[2 * agent + 1] ?? 0;
    if (missing === 0 || !frame.sees(x, y, radius)) continue;
    context.globalAlpha = 0.75 * missing;
    context.strokeStyle = cast.colors[agent] ?? frame.palette.ink3;
    context.beginPath();
    context.arc(x, y, Math.max(1, radius - width / 2), 0, 2 * Math.PI);
    context.stroke();
  }
  context.setLineDash([]);
  context.globalAlpha = 1;
}
