import type { Frame } from "../frame";
import { clamp, fade } from "../spacing";
import { font } from "./text";

/** Discs from this radius on hold a name. */
export const ROOMY_RADIUS = 8;

/** Names inside the discs; they appear as the discs get roomy, at once: none rests half seen. */
export function drawNames(context: CanvasRenderingContext2D, frame: Frame): void {
  // The radius is 0.31 of the spacing: 8 px at 25.8.
  const alpha = fade(frame.spacing, 25.8, 26.2);
  if (frame.radius < ROOMY_RADIUS || alpha === 0) return;
  setNameStyle(context, frame);
  context.globalAlpha = alpha;
  for (let agent = 0; agent < frame.agentCount; agent += 1) {
    if (frame.presence) context.globalAlpha = alpha * (frame.presence[agent] ?? 1);
    if (!frame.isGone?.[agent]) drawName(context, frame, agent);
  }
  context.globalAlpha = 1;
}

/** Font and alignment for `drawName`. */
export function setNameStyle(context: CanvasRenderingContext2D, frame: Frame): void {
  context.font = font(frame.palette, clamp(0.86 * frame.radius, 8, 10));
  context.textAlign = "center";
  context.textBaseline = "middle";
}

/** One name, cut and squeezed to its disc. */
export function drawName(context: CanvasRenderingContext2D, frame: Frame, agent: number): void {
  const x = frame.points[2 * agent] ?? 0;
  const y = frame.points[2 * agent + 1] ?? 0;
  if (!frame.sees(x, y, frame.radius)) return;
  context.fillStyle = frame.cast.inks[agent] ?? frame.palette.sheet;
  context.fillText(frame.cast.shortNames[agent] ?? "", x, y + 0.5, 2 * frame.radius - 2);
}
