import { cutPath } from "./cut-path";
import { updateTrack } from "./edit";
import { barycenterOf } from "./formation";
import { LIMITS } from "./limits";
import type { Keyframe, Scene, Segment, Track, TravelPath } from "./scene";
import { endsAround, liesBetween } from "./stretches";

/** Of sums of two lengths. */
const ROUND_OFF = 1e-12;

/** Whether a keyframe could: it is none of both ends, and the same agents are there on both sides. */
export function mayLieBetween(track: Track, index: number): boolean {
  const keyframe = track.keyframes[index];
  if (!keyframe) return false;
  const between = { ...keyframe, between: 1, corner: false, hold: 0 };
  return liesBetween({ ...track, keyframes: track.keyframes.with(index, between) }, index);
}

/**
 * How deep a keyframe lies among those at `before` and `after` it: a step deeper than either, so that it bends what is
 * there already and moves nobody.
 */
export function depthBetween(track: Track, before: number, after: number): number {
  const depths = [before, after].map((at) => (liesBetween(track, at) ? (track.keyframes[at]?.between ?? 0) : 0));
  return Math.min(LIMITS.keyframes, 1 + Math.max(...depths));
}

/** The scene with one keyframe changed, which may begin or cease to lie in a transition. */
export function reshapeKeyframe(scene: Scene, index: number, change: (keyframe: Keyframe) => Keyframe): Scene {
  return updateTrack(scene, (track) => {
    const keyframe = track.keyframes[index];
    const next = keyframe && change(keyframe);
    if (!next || next === keyframe) return track;
    const changed = { ...track, keyframes: track.keyframes.with(index, next) };
    const wasBetween = liesBetween(track, index);
    if (wasBetween === liesBetween(changed, index)) return changed;
    return wasBetween ? partedAt(changed, index) : joinedAt(changed, index);
  });
}

/** A transition that a keyframe divides now: its path is divided there, and who goes where was found for other ends. */
export function partedAt(track: Track, keyframe: number): Track {
  const { positions } = track.keyframes[keyframe] ?? {};
  const [from] = endsAround(track, keyframe - 1);
  const [, to] = endsAround(track, keyframe);
  const path = track.segments[from]?.path;
  const [before, after] = path && positions ? cutPath(path, positions) : [null, null];
  return along(track, [from, to], (index) => (index < keyframe ? before : after));
}

/**
 * Two transitions that are one now, because the keyframe between them lies in it: along both paths, one after the other.
 * Where there is one path alone, it goes on straight.
 */
function joinedAt(track: Track, keyframe: number): Track {
  const ends = endsAround(track, keyframe);
  const [before, after] = [track.segments[keyframe - 1]?.path, track.segments[keyframe]?.path];
  const path =
    before || after ? joinedPath(before ?? [centerAt(track, ends[0])], after ?? [centerAt(track, ends[1])]) : null;
  const joined = along(track, ends, () => path);
  return {
    ...joined,
    segments: joined.segments.map((was, index) => (index === keyframe ? { ...was, chosen: null } : was)),
  };
}

/** Without the point where they meet, if that lies on the way anyhow. */
function joinedPath(before: TravelPath, after: TravelPath): TravelPath {
  const [start, joint, end] = [before.at(-2), before.at(-1), after[1]];
  const isOnTheWay = start && joint && end && isStraight(start, joint, end);
  return [
    ...(isOnTheWay ? before.slice(0, -1) : before),
    ...(before.length > 1 && after.length > 1 ? after.slice(1) : after),
  ];
}

function isStraight(start: TravelPath[number], joint: TravelPath[number], end: TravelPath[number]): boolean {
  const direct = Math.hypot(end[0] - start[0], end[1] - start[1]);
  const around =
    Math.hypot(joint[0] - start[0], joint[1] - start[1]) + Math.hypot(end[0] - joint[0], end[1] - joint[1]);
  return around - direct <= ROUND_OFF * around;
}

function centerAt(track: Track, keyframe: number): TravelPath[number] {
  const formation = track.keyframes[keyframe]?.positions;
  return formation ? barycenterOf(formation) : [0, 0];
}

function along(track: Track, [from, to]: readonly [number, number], path: (segment: number) => Segment["path"]): Track {
  const segments = track.segments.map((was, index) =>
    index < from || index >= to ? was : { ...was, path: path(index), assignment: null },
  );
  return { ...track, segments };
}
