import type { SegmentMotion } from "../../playback/motion";
import type { Paint } from "../cast";
import type { Frame } from "../frame";
import { fade } from "../spacing";

/** Pieces of the path to come. */
export const PIECES = 14;

const DASHES = [2.5, 2.5];
const SOLID: readonly number[] = [];

/** Which samples each piece lies between, and how far along: one for all who draw. */
export const pieces = { samples: new Int32Array(PIECES + 1), shares: new Float32Array(PIECES + 1) };

/**
 * The way each agent still has to go, dashed from its target backward: the dashes lie still while agents pass over them.
 */
export function drawPathsToCome(
  context: CanvasRenderingContext2D,
  frame: Frame,
  motion: SegmentMotion,
  now: number,
): void {
  const alpha = 0.3 * fade(frame.spacing, 12, 14);
  if (alpha === 0 || now >= motion.end || motion.times.length < 2) return;
  locate(motion, now);
  beginDashes(context, alpha);
  const { paints } = frame.cast;
  for (let k = 0; k < paints.length; k += 1) {
    const paint = paints[k];
    if (paint) strokePaths(context, frame, motion, paint);
  }
  endDashes(context);
}

/** The same before a motion is known: straight to the target. `xy` in meters. */
export function drawStraightPaths(context: CanvasRenderingContext2D, frame: Frame, xy: Float64Array): void {
  const alpha = 0.3 * fade(frame.spacing, 12, 14);
  if (alpha === 0) return;
  const { points } = frame;
  beginDashes(context, alpha);
  for (const { color, agents } of frame.cast.paints) {
    context.strokeStyle = color;
    context.beginPath();
    for (let k = 0; k < agents.length; k += 1) {
      const agent = agents[k] ?? 0;
      if (frame.isGone?.[agent]) continue;
      context.moveTo(frame.screenX(xy[2 * agent] ?? 0), frame.screenY(xy[2 * agent + 1] ?? 0));
      context.lineTo(points[2 * agent] ?? 0, points[2 * agent + 1] ?? 0);
    }
    context.stroke();
  }
  endDashes(context);
}

/** Which samples each piece of the way from the end back to `now` lies between. */
export function locate(motion: SegmentMotion, now: number): void {
  for (let piece = 0; piece <= PIECES; piece += 1) {
    const time = motion.end + ((now - motion.end) * piece) / PIECES;
    const sample = Math.min(motion.sampleBefore(time), motion.times.length - 2);
    const start = motion.times[sample] ?? 0;
    pieces.samples[piece] = sample;
    pieces.shares[piece] = (time - start) / ((motion.times[sample + 1] ?? 0) - start);
  }
}

/** Those of one color. */
function strokePaths(
  context: CanvasRenderingContext2D,
  frame: Frame,
  motion: SegmentMotion,
  { color, agents }: Paint,
): void {
  context.strokeStyle = color;
  context.beginPath();
  for (let k = 0; k < agents.length; k += 1) {
    const agent = agents[k] ?? 0;
    if (!frame.isGone?.[agent]) tracePath(context, frame, motion, agent);
  }
  context.stroke();
}

function tracePath(context: CanvasRenderingContext2D, frame: Frame, { xy }: SegmentMotion, agent: number): void {
  const { camera } = frame;
  const stride = 2 * frame.agentCount;
  for (let piece = 0; piece <= PIECES; piece += 1) {
    const at = (pieces.samples[piece] ?? 0) * stride + 2 * agent;
    const share = pieces.shares[piece] ?? 0;
    const x = xy[at] ?? 0;
    const y = xy[at + 1] ?? 0;
    const px = (x + ((xy[at + stride] ?? 0) - x) * share) * camera.scale + camera.left;
    const py = camera.top - (y + ((xy[at + stride + 1] ?? 0) - y) * share) * camera.scale;
    if (piece === 0) context.moveTo(px, py);
    else context.lineTo(px, py);
  }
}

export function beginDashes(context: CanvasRenderingContext2D, alpha: number): void {
  context.globalAlpha = alpha;
  context.lineWidth = 1;
  // Round ends on hairlines cost four times the drawing; square ones as long look the same.
  context.lineCap = "butt";
  context.setLineDash(DASHES);
}

export function endDashes(context: CanvasRenderingContext2D): void {
  context.globalAlpha = 1;
  context.setLineDash(SOLID);
}
