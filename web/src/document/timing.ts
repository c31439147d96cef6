import { LIMITS, SHORTEST_TRANSITION } from "./limits";
import { mainTrack, type Scene } from "./scene";

/** Counts from one formation to a new one at the end of the show. */
const NEW_TRANSITION_COUNTS = 8;

/** Where the show is at an instant: standing in a keyframe or under way between two. */
export type Moment =
  | { readonly kind: "standing"; readonly keyframe: number }
  | { readonly kind: "moving"; readonly segment: number; readonly nearest: number };

/** Times closer than this are one instant, seconds: half a frame at the highest frame rate. */
export const SAME_INSTANT = 0.004;

/** What the agents do at `time`: before the first and after the last keyframe they stand in it. */
export function momentAt(scene: Scene, time: number): Moment {
  const keyframes = mainTrack(scene).keyframes;
  let index = 0;
  while (index + 1 < keyframes.length && (keyframes[index + 1]?.time ?? 0) <= time + SAME_INSTANT) index += 1;
  const from = keyframes[index];
  const to = keyframes[index + 1];
  if (!from || !to || time <= from.time + from.hold + SAME_INSTANT) return { kind: "standing", keyframe: index };
  const isNearerTo = to.time - time < time - (from.time + from.hold);
  return { kind: "moving", segment: index, nearest: isNearerTo ? index + 1 : index };
}

/**
 * Where a keyframe added at the playhead goes: on the spot while agents move, halfway to the next from a keyframe,
 * eight counts after the last. Null when there is no room.
 */
export function slotAfter(scene: Scene, time: number): { readonly index: number; readonly time: number } | null {
  const keyframes = mainTrack(scene).keyframes;
  const moment = momentAt(scene, time);
  const before = moment.kind === "standing" ? moment.keyframe : moment.segment;
  const from = keyframes[before];
  const to = keyframes[before + 1];
  if (!from) return null;
  const end = from.time + from.hold;
  if (!to) {
    const last = end + (NEW_TRANSITION_COUNTS * 60) / scene.tempo.beatsPerMinute;
    return last <= LIMITS.seconds ? { index: before + 1, time: roundTime(last) } : null;
  }
  const room = to.time - end;
  if (room < 2 * SHORTEST_TRANSITION) return null;
  const wanted = moment.kind === "moving" ? time : end + room / 2;
  const earliest = end + SHORTEST_TRANSITION;
  return { index: before + 1, time: Math.max(earliest, Math.min(to.time - SHORTEST_TRANSITION, roundTime(wanted))) };
}

/** Gestures in time are exact to a millisecond. */
export function roundTime(seconds: number): number {
  return Math.round(seconds * 1000) / 1000;
}
