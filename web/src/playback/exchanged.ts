import { SegmentMotion } from "./motion";

const known = new WeakMap<SegmentMotion, SegmentMotion>();

/** The motion with height and distance from the audience exchanged: as it is drawn from the front. */
export function exchangedMotion(motion: SegmentMotion): SegmentMotion {
  let exchanged = known.get(motion);
  if (!exchanged) {
    const xy = motion.xy.slice();
    const heights = new Float32Array(xy.length / 2);
    for (let k = 0; k < heights.length; k += 1) {
      heights[k] = xy[2 * k + 1] ?? 0;
      xy[2 * k + 1] = motion.heights?.[k] ?? 0;
    }
    exchanged = new SegmentMotion(motion.times, xy, motion.agentCount, heights);
    known.set(motion, exchanged);
  }
  return exchanged;
}
