import { goneIn } from "../document/absence";
import type { Join, Keyframe, Timing, Track } from "../document/scene";
import { isStop } from "../document/stops";
import type { SegmentMotion } from "./motion";

/** Round-off allowed between a keyframe's time and its motion's end, seconds. */
const TIME_TOLERANCE = 1e-6;

/**
 * The show as it is drawn: formations that stand and segments between them.
 *
 * A segment without a motion of the scene as it is moves straight from formation to formation, with its own timing.
 */
export class Show {
  readonly agentCount: number;
  /** Scene seconds, the last hold included. */
  readonly duration: number;
  /** Whether its agents have heights. */
  readonly isSpatial: boolean;
  private readonly motions: readonly (SegmentMotion | null)[];
  /** By segment. */
  private readonly gone: readonly (readonly number[])[];

  constructor(
    private readonly track: Track,
    motions: readonly (SegmentMotion | null)[],
    private readonly join: Join = "separate",
  ) {
    this.agentCount = track.keyframes[0]?.positions.agentCount ?? 0;
    this.duration = showDuration(track);
    this.isSpatial = track.keyframes.some(({ positions }) => positions.heights !== null);
    this.gone = track.segments.map((_, segment) => goneIn(track, segment));
    this.motions = track.segments.map((_, segment) => this.fitting(segment, motions[segment] ?? null));
  }

  /** The last keyframe at or before `time`, or the first. */
  keyframeBefore(time: number): number {
    const { keyframes } = this.track;
    let low = 0;
    let high = keyframes.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if ((keyframes[middle]?.time ?? 0) <= time) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  /** The segment under way at `time`; null while a formation stands. */
  segmentAt(time: number): number | null {
    const index = this.keyframeBefore(time);
    return this.isMoving(index, time) ? index : null;
  }

  /** How much of the time of the segment under way is behind at `time`; null while a formation stands. */
  progressAt(time: number): number | null {
    const segment = this.segmentAt(time);
    return segment === null ? null : this.progressOf(segment, time);
  }

  /** The motion that `segment` is drawn from; null while it is blended. */
  motionOf(segment: number): SegmentMotion | null {
    return this.motions[segment] ?? null;
  }

  /** Whether what is drawn at `time` only stands in for a motion that is not there: nobody is said to clash in it. */
  isBlendedAt(time: number): boolean {
    const segment = this.segmentAt(time);
    return segment !== null && this.motionOf(segment) === null;
  }

  /** Who is not there at `time`, ascending. */
  absentAt(time: number): readonly number[] {
    const index = this.keyframeBefore(time);
    return (this.isMoving(index, time) ? this.gone[index] : this.track.keyframes[index]?.absent) ?? [];
  }

  /** When `segment` starts and ends, scene seconds. */
  startOf(segment: number): number {
    return departure(this.track.keyframes[segment]);
  }

  endOf(segment: number): number {
    return this.track.keyframes[segment + 1]?.time ?? this.duration;
  }

  /** Where everybody is at `time`, x, y an agent in meters, into `out`; allocates nothing. */
  positionsInto(time: number, out: Float32Array): void {
    const index = this.keyframeBefore(time);
    if (!this.isMoving(index, time)) {
      const stand = this.track.keyframes[index]?.positions.xy;
      if (stand) out.set(stand);
      return;
    }
    const motion = this.motions[index];
    if (motion) motion.positionsInto(time, out);
    else this.blendInto(index, time, out);
  }

  /** How high everybody is at `time`, meters, into `out`: 0 in a plane scene; allocates nothing. */
  heightsInto(time: number, out: Float32Array): void {
    const index = this.keyframeBefore(time);
    const stand = this.track.keyframes[index]?.positions.heights;
    if (!stand) {
      out.fill(0);
      return;
    }
    if (!this.isMoving(index, time)) {
      out.set(stand);
      return;
    }
    const motion = this.motions[index];
    const to = this.track.keyframes[index + 1]?.positions.heights;
    if (motion) motion.heightsInto(time, out);
    else if (to) mixInto(stand, to, this.shareOf(index, time), out);
  }

  private isMoving(index: number, time: number): boolean {
    const keyframe = this.track.keyframes[index];
    return index + 1 < this.track.keyframes.length && time > departure(keyframe);
  }

  private blendInto(segment: number, time: number, out: Float32Array): void {
    const from = this.track.keyframes[segment]?.positions.xy;
    const to = this.track.keyframes[segment + 1]?.positions.xy;
    if (from && to) mixInto(from, to, this.shareOf(segment, time), out);
  }

  /** How much of a segment's way is behind at `time`. */
  private shareOf(segment: number, time: number): number {
    const timing = this.track.segments[segment]?.timing ?? "linear";
    const share = this.progressOf(segment, time);
    return eased(timing, share, isStop(this.track, this.join, segment), isStop(this.track, this.join, segment + 1));
  }

  private progressOf(segment: number, time: number): number {
    const start = this.startOf(segment);
    return (time - start) / (this.endOf(segment) - start);
  }

  /** A motion of other agents or other times belongs to a scene that has changed since. */
  private fitting(segment: number, motion: SegmentMotion | null): SegmentMotion | null {
    if (motion?.agentCount !== this.agentCount) return null;
    const isStarting = Math.abs(motion.start - this.startOf(segment)) <= TIME_TOLERANCE;
    const isEnding = Math.abs(motion.end - this.endOf(segment)) <= TIME_TOLERANCE;
    return isStarting && isEnding ? motion : null;
  }
}

/** Scene seconds until the last formation has stood. */
export function showDuration(track: Track): number {
  return departure(track.keyframes[track.keyframes.length - 1]);
}

/** The parameter at share `t` of a segment's time: smooth timing eases where the agents stop. */
export function eased(timing: Timing, t: number, stopsBefore: boolean, stopsAfter: boolean): number {
  if (timing !== "smooth" || (!stopsBefore && !stopsAfter)) return t;
  if (!stopsAfter) return t * t * (2 - t);
  return stopsBefore ? t * t * (3 - 2 * t) : t * (1 + t - t * t);
}

function departure(keyframe: Keyframe | undefined): number {
  return keyframe ? keyframe.time + keyframe.hold : 0;
}

function mixInto(from: Float64Array, to: Float64Array, t: number, out: Float32Array): void {
  for (let k = 0; k < from.length; k += 1) {
    const a = from[k] ?? 0;
    out[k] = a + ((to[k] ?? 0) - a) * t;
  }
}
