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
  /** Halfway in time, wherever there was room for the transition itself. */
  readonly middle: number;
  /** Whether it has no room between the thumbnails, and so is a small mark over them. */
  readonly isMark: boolean;
}

/** Between a thumbnail and the frame of a ribbon. */
const GAP = 3;
const LEAST_RIBBON = 8;
const MARK_WIDTH = 14;
/** The frame of one mark ends where that of the next begins. */
const MARK_STEP = 15;

/** Beside a name, so that two do not read as one. */
const NAME_GAP = 6;
const NAME_WIDTH = 104;
/** Shorter ones say too little. */
const LEAST_NAME = 44;

export function keyframePlaces(keyframes: readonly Keyframe[], scale: Scale): KeyframePlace[] {
  return keyframes.map(({ time, hold }) => ({
    x: xOf(scale, time),
    right: xOf(scale, time + hold) + THUMBNAIL_WIDTH / 2,
  }));
}

/** `places[i]` of the transition from keyframe i to i + 1. Marks stand side by side however near their keyframes are. */
export function transitionPlaces(keyframes: readonly KeyframePlace[]): TransitionPlace[] {
  let free = Number.NEGATIVE_INFINITY;
  return keyframes.slice(1).map((next, index) => {
    const left = (keyframes[index]?.right ?? 0) + GAP;
    const right = next.x - THUMBNAIL_WIDTH / 2 - GAP;
    const middle = (left + right) / 2;
    if (right - left >= LEAST_RIBBON) return { left, width: right - left, middle, isMark: false };
    const place = { left: Math.max(free, middle - MARK_WIDTH / 2), width: MARK_WIDTH, middle, isMark: true };
    free = place.left + MARK_STEP;
    return place;
  });
}

/**
 * How wide the name below each thumbnail may be, about its middle, so that none is printed over another; 0 where it
 * gives way. That of keyframe `first` never does.
 */
export function nameWidths(keyframes: readonly KeyframePlace[], first: number): number[] {
  const kept: number[] = [];
  const hasRoom = (x: number) => kept.every((k) => Math.abs((keyframes[k]?.x ?? 0) - x) >= LEAST_NAME + NAME_GAP);
  for (const index of [first, ...keyframes.keys()]) {
    const place = keyframes[index];
    if (place && hasRoom(place.x)) kept.push(index);
  }
  kept.sort((a, b) => a - b);
  const widths = keyframes.map(() => 0);
  kept.forEach((index, k) => {
    const x = keyframes[index]?.x ?? 0;
    const before = keyframes[kept[k - 1] ?? -1]?.x ?? Number.NEGATIVE_INFINITY;
    const after = keyframes[kept[k + 1] ?? -1]?.x ?? Number.POSITIVE_INFINITY;
    widths[index] = Math.min(NAME_WIDTH, x - before - NAME_GAP, after - x - NAME_GAP);
  });
  return widths;
}
