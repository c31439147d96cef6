import type { SegmentMotion } from "../../playback/motion";

/** Places kept of all paths of a motion: a long motion of a crowd is measured at fewer samples. */
const MOST_PLACES = 2_000_000;

/** How far each agent has come along its path since a motion began. */
export class Distances {
  /** Samples of the motion, from each kept place to the next. */
  private readonly every: number;
  /** Meters since the start: of every agent at the first kept sample, then at the second, … */
  private readonly sums: Float32Array;
  /** Meters that each agent walks in all. */
  readonly totals: Float32Array;

  constructor(private readonly motion: SegmentMotion) {
    const { times, xy, agentCount } = motion;
    this.every = Math.max(1, Math.ceil((times.length * agentCount) / MOST_PLACES));
    const kept = Math.ceil((times.length - 1) / this.every) + 1;
    this.sums = new Float32Array(kept * agentCount);
    for (let place = 1; place < kept; place += 1) {
      const from = this.sampleOf(place - 1) * agentCount * 2;
      const to = this.sampleOf(place) * agentCount * 2;
      for (let agent = 0; agent < agentCount; agent += 1) {
        const dx = (xy[to + 2 * agent] ?? 0) - (xy[from + 2 * agent] ?? 0);
        const dy = (xy[to + 2 * agent + 1] ?? 0) - (xy[from + 2 * agent + 1] ?? 0);
        const before = this.sums[(place - 1) * agentCount + agent] ?? 0;
        this.sums[place * agentCount + agent] = before + Math.sqrt(dx * dx + dy * dy);
      }
    }
    this.totals = this.sums.subarray((kept - 1) * agentCount);
  }

  /** Meters that everybody has walked at `time`, scene seconds, into `out`; allocates nothing. */
  traveledInto(time: number, out: Float32Array): void {
    const { times, agentCount } = this.motion;
    const place = Math.floor(this.motion.sampleBefore(time) / this.every);
    const next = Math.min(place + 1, this.sums.length / agentCount - 1);
    const from = times[this.sampleOf(place)] ?? 0;
    const span = (times[this.sampleOf(next)] ?? 0) - from;
    const t = span > 0 ? Math.min(1, Math.max(0, (time - from) / span)) : 0;
    for (let agent = 0; agent < agentCount; agent += 1) {
      const start = this.sums[place * agentCount + agent] ?? 0;
      out[agent] = start + ((this.sums[next * agentCount + agent] ?? 0) - start) * t;
    }
  }

  private sampleOf(place: number): number {
    return Math.min(place * this.every, this.motion.times.length - 1);
  }
}

const known = new WeakMap<SegmentMotion, Distances>();

/** Measured when it is first asked for. */
export function distancesOf(motion: SegmentMotion): Distances {
  let distances = known.get(motion);
  if (!distances) {
    distances = new Distances(motion);
    known.set(motion, distances);
  }
  return distances;
}

/** Strides, two steps each, on a way of `total` meters: whole ones, so that the next way goes on from the same foot. */
export function strideCount(total: number, stride: number): number {
  return Math.max(1, Math.round(total / stride));
}
