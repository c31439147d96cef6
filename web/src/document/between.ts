import { cutPath } from "./cut-path";
import { updateTrack } from "./edit";
import type { Keyframe, Scene, Segment, Track } from "./scene";
import { endsAround, liesBetween } from "./stretches";

/** Whether a keyframe could: it is none of both ends, and the same agents are there on both sides. */
export function mayLieBetween(track: Track, index: number): boolean {
  const keyframe = track.keyframes[index];
  if (!keyframe) return false;
  const between = { ...keyframe, between: true, corner: false, hold: 0 };
  return liesBetween({ ...track, keyframes: track.keyframes.with(index, between) }, index);
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

/** Two transitions that are one now, because the keyframe between them lies in it: along both paths, if both have one. */
function joinedAt(track: Track, keyframe: number): Track {
  const [before, after] = [track.segments[keyframe - 1]?.path, track.segments[keyframe]?.path];
  const path = before && after ? [...before, ...after.slice(1)] : null;
  const joined = along(track, endsAround(track, keyframe), () => path);
  return {
    ...joined,
    segments: joined.segments.map((was, index) => (index === keyframe ? { ...was, chosen: null } : was)),
  };
}

function along(track: Track, [from, to]: readonly [number, number], path: (segment: number) => Segment["path"]): Track {
  const segments = track.segments.map((was, index) =>
    index < from || index >= to ? was : { ...was, path: path(index), assignment: null },
  );
  return { ...track, segments };
}
