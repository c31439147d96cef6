import type { Show } from "../../playback/show";
import { smoothstep } from "../spacing";
import type { BodyKind } from "./bodies";
import { bankOf, headingOf, pitchOf, WINDOW } from "./course";
import { gaitsInto, type Limbs } from "./gait";
import type { BodySizes } from "./sizes";
import { distancesOf, strideCount } from "./stride";

/** A stride is two steps; people take it as long as this share of their height. */
const STRIDE = 0.86;

/** Feet swing fully from this share of the height a `WINDOW` on, and not at all at rest. */
const STROLL = 0.05;

/** No leg reaches farther, as a share of the height. */
const LONGEST_REACH = 0.28;

/** Who is not there is put so far away that nobody sees them, and apart from one another; meters. */
const AWAY = 1e7;
const GAP = 1e3;

/** What is filled for the graphics card: see `Instances`. */
export interface Poses {
  readonly place: Float32Array;
  readonly ahead: Float32Array;
  readonly left: Float32Array;
  readonly limbs: Limbs;
}

/** Reads where everybody is and how they move out of the show. A pose depends on the time alone, not on how it was reached. */
export class Movement {
  /** Where everybody is: x, y an agent, meters. */
  readonly now: Float32Array;
  private readonly before: Float32Array;
  private readonly after: Float32Array;
  /** How high everybody is, meters. */
  readonly high: Float32Array;
  /** Heights at the other times. */
  private readonly highBefore: Float32Array;
  private readonly highAfter: Float32Array;
  private readonly traveled: Float32Array;
  /** Strides done and how far a foot reaches, by agent. */
  private readonly phases: Float64Array;
  private readonly reaches: Float64Array;
  /** Of a segment without a motion: its ends, and how far it is between them. */
  private readonly from: Float32Array;
  private readonly to: Float32Array;
  private readonly straight: Float32Array;

  constructor(private readonly count: number) {
    this.now = new Float32Array(2 * count);
    this.before = new Float32Array(2 * count);
    this.after = new Float32Array(2 * count);
    this.high = new Float32Array(count);
    this.highBefore = new Float32Array(count);
    this.highAfter = new Float32Array(count);
    this.traveled = new Float32Array(count);
    this.phases = new Float64Array(count);
    this.reaches = new Float64Array(count);
    this.from = new Float32Array(2 * count);
    this.to = new Float32Array(2 * count);
    this.straight = new Float32Array(count);
  }

  /** Everybody's pose at `time`, scene seconds; allocates nothing. */
  poseInto(show: Show, time: number, kind: BodyKind, sizes: BodySizes, poses: Poses): void {
    const earlier = Math.max(time - WINDOW, 0);
    const later = Math.min(time + WINDOW, show.duration);
    show.positionsInto(time, this.now);
    this.sendAway(show.absentAt(time));
    show.positionsInto(earlier, this.before);
    show.positionsInto(later, this.after);
    show.heightsInto(time, this.high);
    show.heightsInto(earlier, this.highBefore);
    show.heightsInto(later, this.highAfter);
    for (let agent = 0; agent < this.count; agent += 1) {
      poses.place[3 * agent] = this.now[2 * agent] ?? 0;
      poses.place[3 * agent + 1] = this.now[2 * agent + 1] ?? 0;
      poses.place[3 * agent + 2] = this.high[agent] ?? 0;
      this.aimInto(agent, kind === "cones", poses.ahead, poses.left);
    }
    if (kind === "figures") this.walkInto(show, time, sizes, poses.limbs);
  }

  private sendAway(absent: readonly number[]): void {
    for (let k = 0; k < absent.length; k += 1) {
      const agent = absent[k] ?? 0;
      this.now[2 * agent] = AWAY + GAP * agent;
    }
  }

  /** Which way `agent` heads and, of who flies, climbs and leans. */
  private aimInto(agent: number, isFlying: boolean, ahead: Float32Array, left: Float32Array): void {
    const { before, now, after } = this;
    const x = 2 * agent;
    const y = x + 1;
    const ax = (now[x] ?? 0) - (before[x] ?? 0);
    const ay = (now[y] ?? 0) - (before[y] ?? 0);
    const bx = (after[x] ?? 0) - (now[x] ?? 0);
    const by = (after[y] ?? 0) - (now[y] ?? 0);
    const heading = headingOf(ax + bx, ay + by);
    const rise = (this.highAfter[agent] ?? 0) - (this.highBefore[agent] ?? 0);
    const pitch = isFlying ? pitchOf(ax + bx, ay + by, rise) : 0;
    const bank = isFlying ? bankOf(ax, ay, bx, by) : 0;
    const cos = Math.cos(heading);
    const sin = Math.sin(heading);
    const level = Math.cos(pitch);
    const climb = Math.sin(pitch);
    const upright = Math.cos(bank);
    const lean = Math.sin(bank);
    const k = 3 * agent;
    ahead[k] = cos * level;
    ahead[k + 1] = sin * level;
    ahead[k + 2] = climb;
    // Level it points to the left; leaning, down with the inner wing.
    left[k] = -sin * upright + cos * climb * lean;
    left[k + 1] = cos * upright + sin * climb * lean;
    left[k + 2] = -level * lean;
  }

  private walkInto(show: Show, time: number, { figure, shares }: BodySizes, limbs: Limbs): void {
    const segment = show.segmentAt(time);
    const { before, now, after, traveled, phases, reaches } = this;
    if (segment === null) {
      phases.fill(0);
      reaches.fill(0);
      gaitsInto(phases, reaches, limbs);
      return;
    }
    const totals = this.measure(show, segment, time);
    for (let agent = 0; agent < this.count; agent += 1) {
      const height = figure * (shares[agent] ?? 1);
      const total = totals[agent] ?? 0;
      const strides = strideCount(total, STRIDE * height);
      // Who comes from standing or is about to stand takes shorter steps, and none at the stop itself.
      const step = Math.min(squaredStep(before, now, 2 * agent), squaredStep(now, after, 2 * agent));
      const vigor = smoothstep(0, STROLL, Math.sqrt(step) / height);
      phases[agent] = total > 0 ? (strides * (traveled[agent] ?? 0)) / total : 0;
      reaches[agent] = Math.min(total / strides / 4 / height, LONGEST_REACH) * vigor;
    }
    gaitsInto(phases, reaches, limbs);
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
