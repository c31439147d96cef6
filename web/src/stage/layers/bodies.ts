import type { Frame } from "../frame";
import { ROOMY_RADIUS } from "./names";

/** How firm the edge of a body is, and of one that is selected; and how firm what is within. */
const EDGE = 0.5;
const CHOSEN_EDGE = 0.9;
const WITHIN = 0.1;

/** CSS pixels: a body that reaches so little beyond its disc, or stays so little within, is its disc. */
const SLACK = 1;

/** Of a disc's radius, what its name takes up. */
const AROUND_NAME = 0.6;

/** What agents with a radius of their own take up beyond their discs: as much as they do, edged and faint within. */
export function drawBodies(context: CanvasRenderingContext2D, frame: Frame, isMarked: Uint8Array | null): void {
  context.lineWidth = 1;
  forEachBody(frame, (agent, x, y, reach) => {
    if (reach < frame.radius + SLACK) return;
    context.beginPath();
    context.arc(x, y, reach, 0, 2 * Math.PI);
    ink(context, frame, agent, frame.cast.colors, WITHIN);
    context.fill();
    ink(context, frame, agent, frame.cast.colors, isMarked?.[agent] ? CHOSEN_EDGE : EDGE);
    context.stroke();
  });
  context.globalAlpha = 1;
}

/** The same of who is smaller than their discs: a ring in them, around the name where they hold one. */
export function drawCores(context: CanvasRenderingContext2D, frame: Frame, isMarked: Uint8Array | null): void {
  const holdsName = frame.radius >= ROOMY_RADIUS;
  context.lineWidth = 1;
  forEachBody(frame, (agent, x, y, reach) => {
    if (reach > frame.radius - SLACK || (holdsName && reach < AROUND_NAME * frame.radius)) return;
    context.beginPath();
    context.arc(x, y, Math.max(0.5, reach), 0, 2 * Math.PI);
    ink(context, frame, agent, frame.cast.inks, isMarked?.[agent] ? CHOSEN_EDGE : EDGE);
    context.stroke();
  });
  context.globalAlpha = 1;
}

/** `reach` is the radius of a body, CSS pixels. */
function forEachBody(frame: Frame, draw: (agent: number, x: number, y: number, reach: number) => void): void {
  const { points, isGone, camera } = frame;
  frame.cast.bodies?.forEach((radius, agent) => {
    const x = points[2 * agent] ?? 0;
    const y = points[2 * agent + 1] ?? 0;
    const reach = (radius ?? 0) * camera.scale;
    if (radius !== null && !isGone?.[agent] && frame.sees(x, y, reach)) draw(agent, x, y, reach);
  });
}

function ink(
  context: CanvasRenderingContext2D,
  { palette, presence }: Frame,
  agent: number,
  colors: readonly string[],
  firmness: number,
): void {
  context.fillStyle = colors[agent] ?? palette.ink;
  context.strokeStyle = context.fillStyle;
  context.globalAlpha = firmness * (presence?.[agent] ?? 1);
}
