import type { SegmentMotion } from "../../playback/motion";
import type { Frame } from "../frame";
import { outlineInto, stepAlpha, type TrailLook, trailLook } from "../ribbon";

/** Ribbons filled as one path: few enough that the rasterizer's edge list stays short. */
const BATCH = 16;

/** A stretch of a motion that is drawn, scene seconds. */
export interface TrailSpan {
  readonly motion: SegmentMotion;
  readonly now: number;
  /** 1, or less while a trail fades. */
  readonly strength: number;
}

/** Ribbons from where the agents were to where they are, thin and faint to thick and firm. Owns its buffers. */
export function createTrailsLayer(): (context: CanvasRenderingContext2D, frame: Frame, span: TrailSpan) => void {
  let outlines = new Float32Array(0);
  let line = new Float32Array(0);
  let samples = new Int32Array(0);
  let shares = new Float32Array(0);
  /** 1 where an agent has a trail to see. */
  let isSeen = new Uint8Array(0);

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
      isSeen[agent] = travel > radius && isInSight ? 1 : 0;
      if (isSeen[agent] === 1) {
        outlineInto(line, places, look.tailWidth, look.headWidth, outlines, 4 * agent * places);
      }
    }
  }

  function fillStep(context: CanvasRenderingContext2D, agents: Uint32Array, places: number, from: number, to: number) {
    let inPath = 0;
    context.beginPath();
    for (const agent of agents) {
      if (isSeen[agent] !== 1) continue;
      const base = 4 * agent * places;
      context.moveTo(outlines[base + 4 * from] ?? 0, outlines[base + 4 * from + 1] ?? 0);
      for (let place = from + 1; place <= to; place += 1) {
        context.lineTo(outlines[base + 4 * place] ?? 0, outlines[base + 4 * place + 1] ?? 0);
      }
      for (let place = to; place >= from; place -= 1) {
        context.lineTo(outlines[base + 4 * place + 2] ?? 0, outlines[base + 4 * place + 3] ?? 0);
      }
      context.closePath();
      inPath += 1;
      if (inPath === BATCH) {
        context.fill();
        context.beginPath();
        inPath = 0;
      }
    }
    if (inPath > 0) context.fill();
  }

  return (context, frame, { motion, now, strength }) => {
    const duration = motion.end - motion.start;
    if (duration <= 0 || motion.times.length < 2 || strength <= 0) return;
    const look = trailLook(frame.spacing, frame.radius, frame.palette.trailAlpha, frame.agentCount);
    const from = Math.max(motion.start, now - look.reach * duration);
    if (now - from < 1e-3) return;
    const places = look.steps * look.bends + 1;
    makeRoom(frame.agentCount, places);
    locate(motion, from, Math.min(now, motion.end), places);
    outline(frame, motion, look, places);
    for (const { color, agents } of frame.cast.paints) {
      context.fillStyle = color;
      for (let step = 0; step < look.steps; step += 1) {
        context.globalAlpha = stepAlpha(look, step) * strength;
        fillStep(context, agents, places, step * look.bends, (look.isLayered ? look.steps : step + 1) * look.bends);
      }
    }
    context.globalAlpha = 1;
  };
}
