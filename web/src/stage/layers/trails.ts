import type { SegmentMotion } from "../../playback/motion";
import type { Paint } from "../cast";
import type { Frame } from "../frame";
import { outlineInto, type TrailLook, trailLook } from "../ribbon";

/** A step that bends less than this, CSS pixels, is drawn straight: four corners fill far faster than a bent outline. */
const STRAIGHT = 0.35;

/** Draws the trails of `motion` at `now`, scene seconds; `strength` is 1, or less while they fade. */
type DrawTrails = (
  context: CanvasRenderingContext2D,
  frame: Frame,
  motion: SegmentMotion,
  now: number,
  strength: number,
) => void;

/** Ribbons from where the agents were to where they are, thin and faint to thick and firm. Owns its buffers. */
export function createTrailsLayer(): DrawTrails {
  let outlines = new Float32Array(0);
  let line = new Float32Array(0);
  let samples = new Int32Array(0);
  let shares = new Float32Array(0);
  /** 1 where an agent has a trail to see. */
  let isSeen = new Uint8Array(0);
  const lookOf = createLookKeeper();

  function makeRoom(agentCount: number, places: number): void {
    if (outlines.length < 4 * agentCount * places) outlines = new Float32Array(4 * agentCount * places);
    if (isSeen.length < agentCount) isSeen = new Uint8Array(agentCount);
    if (samples.length < places) {
      samples = new Int32Array(places);
      shares = new Float32Array(places);
      line = new Float32Array(2 * places);
    }
  }

  /** Which samples of the motion each place of a trail lies between. */
  function locate(motion: SegmentMotion, from: number, to: number, places: number): void {
    for (let place = 0; place < places; place += 1) {
      const time = from + ((to - from) * place) / (places - 1);
      const sample = Math.min(motion.sampleBefore(time), motion.times.length - 2);
      const start = motion.times[sample] ?? 0;
      const length = (motion.times[sample + 1] ?? 0) - start;
      samples[place] = sample;
      shares[place] = length > 0 ? (time - start) / length : 0;
    }
  }

  function outline(frame: Frame, motion: SegmentMotion, look: TrailLook, places: number): void {
    const { camera, radius, agentCount } = frame;
    const stride = 2 * agentCount;
    const { xy } = motion;
    for (let agent = 0; agent < agentCount; agent += 1) {
      let travel = 0;
      for (let place = 0; place < places; place += 1) {
        const at = (samples[place] ?? 0) * stride + 2 * agent;
        const share = shares[place] ?? 0;
        const x = xy[at] ?? 0;
        const y = xy[at + 1] ?? 0;
        const px = (x + ((xy[at + stride] ?? 0) - x) * share) * camera.scale + camera.left;
        const py = camera.top - (y + ((xy[at + stride + 1] ?? 0) - y) * share) * camera.scale;
        if (place > 0) travel += Math.abs(px - (line[2 * place - 2] ?? 0)) + Math.abs(py - (line[2 * place - 1] ?? 0));
        line[2 * place] = px;
        line[2 * place + 1] = py;
      }
      // What does not leave its disc is not seen, nor what lies wholly outside.
      const middle = 2 * (places >> 1);
      const isInSight = frame.sees(line[middle] ?? 0, line[middle + 1] ?? 0, travel + radius);
      isSeen[agent] = travel > radius && isInSight && !frame.isGone?.[agent] ? 1 : 0;
      if (isSeen[agent] === 1) {
        // A trail gets thin with who fades at its end.
        const part = frame.presence?.[agent] ?? 1;
        outlineInto(line, places, look.tailWidth * part, look.headWidth * part, outlines, 4 * agent * places);
      }
    }
  }

  /** Whether the places between two lie on the line from one to the other. */
  function isStraight(base: number, from: number, to: number): boolean {
    const a = base + 4 * from;
    const b = base + 4 * to;
    const dx = (outlines[b] ?? 0) - (outlines[a] ?? 0);
    const dy = (outlines[b + 1] ?? 0) - (outlines[a + 1] ?? 0);
    const limit = STRAIGHT * Math.sqrt(dx * dx + dy * dy);
    for (let place = from + 1; place < to; place += 1) {
      const k = base + 4 * place;
      const x = (outlines[k] ?? 0) - (outlines[a] ?? 0);
      const y = (outlines[k + 1] ?? 0) - (outlines[a + 1] ?? 0);
      if (Math.abs(x * dy - y * dx) > limit) return false;
    }
    return true;
  }

  function fillPiece(context: CanvasRenderingContext2D, base: number, from: number, to: number): void {
    const stride = isStraight(base, from, to) ? to - from : 1;
    context.beginPath();
    for (let place = from; place <= to; place += stride) {
      context.lineTo(outlines[base + 4 * place] ?? 0, outlines[base + 4 * place + 1] ?? 0);
    }
    for (let place = to; place >= from; place -= stride) {
      context.lineTo(outlines[base + 4 * place + 2] ?? 0, outlines[base + 4 * place + 3] ?? 0);
    }
    context.fill();
  }

  function fillTrails(
    context: CanvasRenderingContext2D,
    { color, agents }: Paint,
    look: TrailLook,
    strength: number,
  ): void {
    const places = look.steps * look.bends + 1;
    context.fillStyle = color;
    for (let step = 0; step < look.steps; step += 1) {
      context.globalAlpha = (look.alphas[step] ?? 0) * strength;
      const from = step * look.bends;
      const to = look.isLayered ? places - 1 : from + look.bends;
      for (let k = 0; k < agents.length; k += 1) {
        const agent = agents[k] ?? 0;
        if (isSeen[agent] === 1) fillPiece(context, 4 * agent * places, from, to);
      }
    }
  }

  return (context, frame, motion, now, strength) => {
    const duration = motion.end - motion.start;
    if (duration <= 0 || motion.times.length < 2 || strength <= 0) return;
    const look = lookOf(frame);
    const from = Math.max(motion.start, now - look.reach * duration);
    if (now - from < 1e-3) return;
    const places = look.steps * look.bends + 1;
    makeRoom(frame.agentCount, places);
    locate(motion, from, Math.min(now, motion.end), places);
    outline(frame, motion, look, places);
    // By index, here as in all that is drawn each frame: an iterator's answers would have to be collected.
    const { paints } = frame.cast;
    for (let k = 0; k < paints.length; k += 1) {
      const paint = paints[k];
      if (paint) fillTrails(context, paint, look, strength);
    }
    context.globalAlpha = 1;
  };
}

/** Makes a look anew only where it is another. */
function createLookKeeper(): (frame: Frame) => TrailLook {
  let look: TrailLook | null = null;
  let spacing = 0;
  let trailAlpha = 0;
  let agentCount = 0;
  return (frame) => {
    const isSame =
      frame.spacing === spacing && frame.palette.trailAlpha === trailAlpha && frame.agentCount === agentCount;
    if (look && isSame) return look;
    spacing = frame.spacing;
    trailAlpha = frame.palette.trailAlpha;
    agentCount = frame.agentCount;
    look = trailLook(spacing, frame.radius, trailAlpha, agentCount);
    return look;
  };
}
