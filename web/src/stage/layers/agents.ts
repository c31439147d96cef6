import type { Frame } from "../frame";
import { clamp } from "../spacing";
import { createSprites, type Sprites } from "../sprites";

/** More discs than this are stamped from sprites; fewer are drawn where they are to a fraction of a pixel. */
const MANY = 60;

/** Discs over a halo of the sheet, in order: a later agent lies on top. Owns its sprites. */
export function createAgentsLayer(): (context: CanvasRenderingContext2D, frame: Frame) => void {
  let sprites: Sprites | null = null;
  return (context, frame) => {
    if (frame.agentCount <= MANY) {
      for (let agent = 0; agent < frame.agentCount; agent += 1) {
        context.globalAlpha = frame.presence?.[agent] ?? 1;
        if (!frame.isGone?.[agent]) drawAgent(context, frame, agent);
      }
      context.globalAlpha = 1;
      return;
    }
    const halo = haloWidth(frame.radius);
    if (!sprites?.fits(frame, halo)) sprites = createSprites(frame, halo);
    sprites.stamp(context, frame);
  };
}

/** One agent's disc over its halo. */
export function drawAgent(context: CanvasRenderingContext2D, frame: Frame, agent: number): void {
  const { points, radius, palette, cast } = frame;
  const x = points[2 * agent] ?? 0;
  const y = points[2 * agent + 1] ?? 0;
  const halo = haloWidth(radius);
  if (!frame.sees(x, y, radius + halo)) return;
  if (halo > 0) {
    context.fillStyle = palette.sheet;
    context.beginPath();
    context.arc(x, y, radius + halo, 0, 2 * Math.PI);
    context.fill();
  }
  context.fillStyle = cast.colors[agent] ?? palette.ink;
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fill();
}

/** CSS pixels of sheet around a disc; too small discs have none. */
export function haloWidth(radius: number): number {
  return radius > 2.4 ? clamp(0.22 * radius, 0.5, 2) : 0;
}
