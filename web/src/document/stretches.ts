import { goneIn, goneOnTheWay } from "./absence";
import type { Keyframe, Track } from "./scene";

/** The keyframes that transitions run between, and a track without the others. */
interface Stretches {
  readonly anchors: readonly number[];
  readonly whole: Track;
}

const known = new WeakMap<Track, Stretches>();

/**
 * Which transitions a track has: a keyframe that lies between others bends the one that it lies in, and ends none.
 *
 * It is an end nevertheless where agents stop, and where not the same agents are there all the way.
 */
export function stretchesOf(track: Track): Stretches {
  let stretches = known.get(track);
  if (!stretches) {
    const anchors = anchorsOf(track);
    const { keyframes, segments } = track;
    const isWhole = anchors.length === keyframes.length;
    const whole = isWhole
      ? track
      : {
          ...track,
          keyframes: anchors.flatMap((at) => keyframes[at] ?? []),
          segments: anchors.flatMap((at) => segments[at] ?? []),
        };
    stretches = { anchors, whole };
    known.set(track, stretches);
  }
  return stretches;
}

/** Whether a keyframe lies in a transition instead of ending it. */
export function liesBetween(track: Track, keyframe: number): boolean {
  return (track.keyframes[keyframe]?.between ?? 0) > 0 && !stretchesOf(track).anchors.includes(keyframe);
}

/** The keyframes that the transition runs between which a segment is, or is a part of. */
export function endsAround(track: Track, segment: number): readonly [from: number, to: number] {
  const { anchors } = stretchesOf(track);
  const next = anchors.findIndex((anchor) => anchor > segment);
  return [anchors[next - 1] ?? segment, anchors[next] ?? segment + 1];
}

function anchorsOf(track: Track): readonly number[] {
  const { keyframes } = track;
  const anchors = [0];
  let start = 0;
  keyframes.forEach((keyframe, end) => {
    if (end === 0 || (end < keyframes.length - 1 && mayBend(keyframe))) return;
    const within = Array.from({ length: end - start }, (_, part) => start + part);
    const isOne = within.length === 1 || areAlike(track, within, goneOnTheWay(keyframes[start], keyframe));
    anchors.push(...(isOne ? [] : within.slice(1)), end);
    start = end;
  });
  return anchors;
}

function mayBend({ between, corner, hold }: Keyframe): boolean {
  return between > 0 && !corner && hold === 0;
}

function areAlike(track: Track, segments: readonly number[], gone: readonly number[]): boolean {
  return segments.every((segment) => goneIn(track, segment).join() === gone.join());
}
