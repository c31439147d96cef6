import type { Frame } from "../frame";
import { clamp, fade, smoothstep } from "../spacing";

/** A group's agents and the ties among them, over which its hull reaches. */
export interface HullShape {
  readonly color: string;
  readonly agents: Uint32Array;
  /** a0, b0, a1, b1, … */
  readonly pairs: Uint32Array;
}

/** Ties up to so many spacings long are covered; the cover retracts from there on, so that a hull never pops. */
const COVERED = { from: 2.6, to: 3.2 } as const;

/** Soft areas behind the groups: one path each, so that a hull has one tone however its parts overlap. */
export function drawHulls(context: CanvasRenderingContext2D, frame: Frame, shapes: readonly HullShape[]): void {
  const alpha = frame.palette.hullAlpha * fade(frame.spacing, 11, 16);
  if (alpha < 0.004) return;
  context.globalAlpha = alpha;
  for (const shape of shapes) {
    context.fillStyle = shape.color;
    traceHull(context, frame, shape, hullWidth(frame) / 2);
    context.fill();
  }
  context.globalAlpha = 1;
}

/**
 * The edge of one hull, 1 px of its color at half strength.
 *
 * `scratch` has the stage's size and density; it is left transparent.
 */
export function drawHullEdge(
  context: CanvasRenderingContext2D,
  frame: Frame,
  shape: HullShape,
  scratch: CanvasRenderingContext2D,
): void {
  if (fade(frame.spacing, 11, 16) === 0) return;
  const half = hullWidth(frame) / 2;
  scratch.fillStyle = shape.color;
  traceHull(scratch, frame, shape, half + 0.5);
  scratch.fill();
  scratch.globalCompositeOperation = "destination-out";
  traceHull(scratch, frame, shape, half - 0.5);
  scratch.fill();
  scratch.globalCompositeOperation = "source-over";
  context.globalAlpha = 0.5;
  context.drawImage(scratch.canvas, 0, 0, frame.size.width, frame.size.height);
  context.globalAlpha = 1;
  scratch.clearRect(0, 0, frame.size.width, frame.size.height);
}

function hullWidth(frame: Frame): number {
  return Math.min(2.3 * clamp(frame.spacing, 9, 400), 84);
}

/** Discs of radius `half` about the agents, and bands as wide along the short ties; all wound alike, so none cancels another. */
function traceHull(context: CanvasRenderingContext2D, frame: Frame, shape: HullShape, half: number): void {
  const { points, spacing } = frame;
  context.beginPath();
  for (const agent of shape.agents) {
    const x = points[2 * agent] ?? 0;
    const y = points[2 * agent + 1] ?? 0;
    if (!frame.sees(x, y, half)) continue;
    context.moveTo(x + half, y);
    context.arc(x, y, half, 0, 2 * Math.PI);
  }
  for (let k = 0; k + 1 < shape.pairs.length; k += 2) {
    const a = 2 * (shape.pairs[k] ?? 0);
    const b = 2 * (shape.pairs[k + 1] ?? 0);
    const ax = points[a] ?? 0;
    const ay = points[a + 1] ?? 0;
    const dx = (points[b] ?? 0) - ax;
    const dy = (points[b + 1] ?? 0) - ay;
    const length = Math.sqrt(dx * dx + dy * dy);
    const cover = 1 - smoothstep(COVERED.from, COVERED.to, length / spacing);
    if (length === 0 || cover === 0 || !frame.sees(ax + dx / 2, ay + dy / 2, half + length)) continue;
    const nx = (-dy / length) * half;
    const ny = (dx / length) * half;
    if (cover === 1) {
      band(context, ax, ay, dx, dy, nx, ny);
    } else {
      const reach = cover / 2;
      stub(context, ax, ay, dx * reach, dy * reach, nx, ny, half);
      stub(context, ax + dx, ay + dy, -dx * reach, -dy * reach, -nx, -ny, half);
    }
  }
}

function band(
  context: CanvasRenderingContext2D,
  x: number,
  y: number,
  dx: number,
  dy: number,
  nx: number,
  ny: number,
): void {
  context.moveTo(x - nx, y - ny);
  context.lineTo(x + dx - nx, y + dy - ny);
  context.lineTo(x + dx + nx, y + dy + ny);
  context.lineTo(x + nx, y + ny);
  context.closePath();
}

/** A band with a round end where it stops short. */
function stub(
  context: CanvasRenderingContext2D,
  x: number,
  y: number,
  dx: number,
  dy: number,
  nx: number,
  ny: number,
  half: number,
): void {
  band(context, x, y, dx, dy, nx, ny);
  context.moveTo(x + dx + half, y + dy);
  context.arc(x + dx, y + dy, half, 0, 2 * Math.PI);
}
