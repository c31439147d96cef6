import type { SegmentMotion } from "../../playback/motion";
import type { Frame } from "../frame";
import { fade } from "../spacing";
import { beginDashes, endDashes, locate, PIECES, pieces } from "./paths";

/**
 * Paths to come while they are planned anew, from formation to formation: the ways of the former motion, drawn to where they begin
 * and end now. `from` and `to` hold x, y an agent, meters.
 */
export function drawFormerPaths(
  context: CanvasRenderingContext2D,
  frame: Frame,
  motion: SegmentMotion,
  from: Float64Array,
  to: Float64Array,
): void {
  const alpha = 0.3 * fade(frame.spacing, 12, 14);
  if (alpha === 0 || motion.times.length < 2) return;
  locate(motion, motion.start);
  beginDashes(context, alpha);
  for (const { color, agents } of frame.cast.paints) {
    context.strokeStyle = color;
    context.beginPath();
    for (let k = 0; k < agents.length; k += 1) {
      const agent = agents[k] ?? 0;
      if (!frame.isGone?.[agent]) traceFormer(context, frame, motion, from, to, agent);
    }
    context.stroke();
  }
  endDashes(context);
}

/** Both ends are moved to where they are now, and what is between as much as it is near to each. */
function traceFormer(
  context: CanvasRenderingContext2D,
  frame: Frame,
  { xy }: SegmentMotion,
  from: Float64Array,
  to: Float64Array,
  agent: number,
): void {
  const stride = 2 * frame.agentCount;
  const first = 2 * agent;
  const last = xy.length - stride + 2 * agent;
  for (let piece = 0; piece <= PIECES; piece += 1) {
    const at = (pieces.samples[piece] ?? 0) * stride + 2 * agent;
    const share = pieces.shares[piece] ?? 0;
    const back = piece / PIECES;
    const x = between(xy, at, stride, share) + moved(xy, first, last, from, to, first, back);
    const y = between(xy, at + 1, stride, share) + moved(xy, first + 1, last + 1, from, to, first + 1, back);
    if (piece === 0) context.moveTo(frame.screenX(x), frame.screenY(y));
    else context.lineTo(frame.screenX(x), frame.screenY(y));
  }
}

function between(xy: Float32Array, at: number, stride: number, share: number): number {
  const start = xy[at] ?? 0;
  return start + ((xy[at + stride] ?? 0) - start) * share;
}

/** How far a coordinate goes with the two ends, `back` of the way from the end to the start. */
function moved(
  xy: Float32Array,
  first: number,
  last: number,
  from: Float64Array,
  to: Float64Array,
  axis: number,
  back: number,
): number {
  return ((from[axis] ?? 0) - (xy[first] ?? 0)) * back + ((to[axis] ?? 0) - (xy[last] ?? 0)) * (1 - back);
}
