import { type Keyframe, mainTrack, type Scene } from "./scene";

/** Where the show is at an instant: standing in a keyframe or under way between two. */
export type Moment =
  | { readonly kind: "standing"; readonly keyframe: number }
  | { readonly kind: "moving"; readonly segment: number; readonly nearest: number };

/** Times closer than this are one instant, seconds: half a frame at the highest frame rate. */
export const SAME_INSTANT = 0.004;

/** What the agents do at `time`: before the first and after the last keyframe they stand in it. */
export function momentAt(scene: Scene, time: number): Moment {
  const keyframes = mainTrack(scene).keyframes;
  const index = keyframeReached(scene, time);
  const from = keyframes[index];
  const to = keyframes[index + 1];
  if (!from || !to || isStill(from, time)) return { kind: "standing", keyframe: index };
  const isNearerTo = to.time - time < time - (from.time + from.hold);
  return { kind: "moving", segment: index, nearest: isNearerTo ? index + 1 : index };
}

/** The keyframe that the agents stand in at `time`, or null; allocates nothing. */
export function standingAt(scene: Scene, time: number): number | null {
  const keyframes = mainTrack(scene).keyframes;
  const index = keyframeReached(scene, time);
  const from = keyframes[index];
  return !from || index + 1 >= keyframes.length || isStill(from, time) ? index : null;
}

function keyframeReached(scene: Scene, time: number): number {
  const keyframes = mainTrack(scene).keyframes;
  let index = 0;
  while (index + 1 < keyframes.length && (keyframes[index + 1]?.time ?? 0) <= time + SAME_INSTANT) index += 1;
  return index;
}

function isStill(from: Keyframe, time: number): boolean {
  return time <= from.time + from.hold + SAME_INSTANT;
}
