import { LIMITS, SHORTEST_TRANSITION } from "./limits";
import { roundTime } from "./round-time";
import { mainTrack, type Scene } from "./scene";
import { momentAt } from "./timing";

/** Counts from one formation to a new one at the end of the show. */
const NEW_TRANSITION_COUNTS = 8;

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
