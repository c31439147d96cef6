import type { Formation, Point } from "../../document/formation";
import type { Bends } from "../../engine/api";
import type { SegmentMotion } from "../../playback/motion";

/** A way is drawn through so many places at most. */
const PLACES = 48;

/** Meters: what is drawn is kept in single precision. */
const SAME_PLACE = 1e-2;

/**
 * Where everybody's way bends, as it is drawn: whoever keeps a place goes as the motion has them go, which may pass an
 * obstacle on another side than the shortest way; of the others only that one is known.
 *
 * @param motion of the transition as it is; null while it is not known
 */
export function waysAlong(motion: SegmentMotion | null, to: Formation, slots: readonly number[], bends: Bends): Bends {
  if (motion?.agentCount !== slots.length) return bends;
  const last = motion.times.length - 1;
  const place = (sample: number, agent: number): Point => {
    const at = 2 * (sample * motion.agentCount + agent);
    return [motion.xy[at] ?? 0, motion.xy[at + 1] ?? 0];
  };
  const stride = Math.ceil(last / PLACES);
  const isKept = (agent: number) => {
    const [x, y] = place(last, agent);
    return slots[agent] === agent && Math.hypot(x - to.x(agent), y - to.y(agent)) < SAME_PLACE;
  };
  return slots.map((_, agent) => {
    if (!isKept(agent)) return bends[agent] ?? [];
    const way: Point[] = [];
    for (let sample = stride; sample < last; sample += stride) way.push(place(sample, agent));
    return way;
  });
}
