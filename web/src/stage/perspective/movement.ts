import type { Show } from "../../playback/show";
import { smoothstep } from "../spacing";
import type { BodyKind } from "./bodies";
import { bankOf, headingOf, pitchOf, WINDOW } from "./course";
import type { BodySizes } from "./sizes";
import { distancesOf, strideCount } from "./stride";

/** A stride is two steps; people take it as long as this share of their height. */
const STRIDE = 0.86;

/** Feet swing fully from this share of the height a `WINDOW` on, and not at all at rest. */
const STROLL = 0.05;

/** No leg reaches farther, as a share of the height. */
const LONGEST_REACH = 0.28;

/** What is filled for the graphics card: see `Instances`. */
export interface Poses {
  readonly place: Float32Array;
  readonly attitude: Float32Array;
}

/** Reads where everybody is and how they move out of the show. A pose depends on the time alone, not on how it was reached. */
export class Movement {
  private readonly now: Float32Array;
  private readonly before: Float32Array;
  private readonly after: Float32Array;
  private readonly traveled: Float32Array;
  /** Of a segment without a motion: its ends, and how far it is between them. */
  private readonly from: Float32Array;
  private readonly to: Float32Array;
  private readonly straight: Float32Array;

  constructor(private readonly count: number) {
    this.now = new Float32Array(2 * count);
    this.before = new Float32Array(2 * count);
    this.after = new Float32Array(2 * count);
    this.traveled = new Float32Array(count);
    this.from = new Float32Array(2 * count);
    this.to = new Float32Array(2 * count);
    this.straight = new Float32Array(count);
  }

  /** Everybody's pose at `time`, scene seconds; allocates nothing. */
  poseInto(show: Show, time: number, kind: BodyKind, sizes: BodySizes, poses: Poses): void {
    show.positionsInto(time, this.now);
    for (let agent = 0; agent < this.count; agent += 1) {
      poses.place[4 * agent] = this.now[2 * agent] ?? 0;
      poses.place[4 * agent + 1] = this.now[2 * agent + 1] ?? 0;
    }
    if (kind === "discs") return;
    show.positionsInto(Math.max(time - WINDOW, 0), this.before);
    show.positionsInto(Math.min(time + WINDOW, show.duration), this.after);
    this.headInto(poses.place);
    if (kind === "cones") this.flyInto(poses);
    else this.walkInto(show, time, sizes.figure, poses.attitude);
  }

  private headInto(place: Float32Array): void {
    const { before, after } = this;
    for (let agent = 0; agent < this.count; agent += 1) {
      const x = 2 * agent;
      const dx = (after[x] ?? 0) - (before[x] ?? 0);
      const dy = (after[x + 1] ?? 0) - (before[x + 1] ?? 0);
      place[4 * agent + 3] = headingOf(dx, dy);
    }
  }

  private flyInto({ attitude }: Poses): void {
    const { before, now, after } = this;
    for (let agent = 0; agent < this.count; agent += 1) {
      const x = 2 * agent;
      const y = x + 1;
      const ax = (now[x] ?? 0) - (before[x] ?? 0);
      const ay = (now[y] ?? 0) - (before[y] ?? 0);
      const bx = (after[x] ?? 0) - (now[x] ?? 0);
      const by = (after[y] ?? 0) - (now[y] ?? 0);
      attitude[x] = pitchOf(ax + bx, ay + by, 0);
      attitude[y] = bankOf(ax, ay, bx, by);
    }
  }

  /** Strides walked, and how far a foot reaches forward. */
  private walkInto(show: Show, time: number, height: number, attitude: Float32Array): void {
    const segment = show.segmentAt(time);
    if (segment === null) {
      attitude.fill(0);
      return;
    }
    const totals = this.measure(show, segment, time);
    const { before, now, after, traveled } = this;
    for (let agent = 0; agent < this.count; agent += 1) {
      const x = 2 * agent;
      const back = squaredStep(before, now, x);
      const ahead = squaredStep(now, after, x);
      // Who comes from standing or is about to stand takes shorter steps, and none at the stop itself.
      const pace = Math.sqrt(Math.min(back, ahead)) / height;
      const total = totals[agent] ?? 0;
      const strides = strideCount(total, STRIDE * height);
      const phase = total > 0 ? (strides * (traveled[agent] ?? 0)) / total : 0;
      attitude[x] = phase - Math.floor(phase);
      attitude[x + 1] = Math.min(total / strides / 4 / height, LONGEST_REACH) * smoothstep(0, STROLL, pace);
    }
  }

  /** Fills `traveled` and answers how far everybody walks in all; straight while there is no motion. */
  private measure(show: Show, segment: number, time: number): Float32Array {
    const { now, traveled, from, to, straight } = this;
    const motion = show.motionOf(segment);
    if (motion) {
      const distances = distancesOf(motion);
      distances.traveledInto(time, traveled);
      return distances.totals;
    }
    show.positionsInto(show.startOf(segment), from);
    show.positionsInto(show.endOf(segment), to);
    for (let agent = 0; agent < this.count; agent += 1) {
      traveled[agent] = Math.sqrt(squaredStep(from, now, 2 * agent));
      straight[agent] = Math.sqrt(squaredStep(from, to, 2 * agent));
    }
    return straight;
  }
}

function squaredStep(from: Float32Array, to: Float32Array, x: number): number {
  const dx = (to[x] ?? 0) - (from[x] ?? 0);
  const dy = (to[x + 1] ?? 0) - (from[x + 1] ?? 0);
  return dx * dx + dy * dy;
}
