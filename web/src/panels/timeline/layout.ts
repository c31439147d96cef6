import type { Keyframe } from "../../document/scene";
import { type Scale, THUMBNAIL_WIDTH, xOf } from "./scale";

/** Where the parts of the timeline stand, CSS pixels from the left end of the track. */
export interface KeyframePlace {
  /** Middle of the thumbnail. */
  readonly x: number;
  /** Right end of the thumbnail, or of the bar that its hold draws on. */
  readonly right: number;
}

export interface TransitionPlace {
  readonly left: number;
  readonly width: number;
}

/** Between a thumbnail and the frame of a ribbon. */
const GAP = 3;

export function keyframePlaces(keyframes: readonly Keyframe[], scale: Scale): KeyframePlace[] {
  return keyframes.map(({ time, hold }) => ({
    x: xOf(scale, time),
    right: xOf(scale, time + hold) + THUMBNAIL_WIDTH / 2,
  }));
}

/** `places[i]` of the transition from keyframe i to i + 1; its width is 0 where the thumbnails leave no room. */
export function transitionPlaces(keyframes: readonly KeyframePlace[]): TransitionPlace[] {
  return keyframes.slice(1).map((next, index) => {
    const left = (keyframes[index]?.right ?? 0) + GAP;
    const right = next.x - THUMBNAIL_WIDTH / 2 - GAP;
    return { left, width: Math.max(0, right - left) };
  });
}
