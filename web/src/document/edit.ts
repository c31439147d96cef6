import { withAlikeParts } from "./parts";
import { type AdjacencySpec, type Keyframe, mainTrack, type Scene, type Segment, type Track } from "./scene";
import { endsAround, liesBetween } from "./stretches";

/** The scene with its one track changed; the same scene when the track is. Parts of one transition stay alike. */
export function updateTrack(scene: Scene, change: (track: Track) => Track): Scene {
  const track = mainTrack(scene);
  const next = change(track);
  return next === track ? scene : { ...scene, tracks: [withAlikeParts(next)] };
}

/** The scene with one keyframe changed. A new formation or adjacency makes auto choose its transitions again. */
export function updateKeyframe(scene: Scene, index: number, change: (keyframe: Keyframe) => Keyframe): Scene {
  return updateTrack(scene, (track) => {
    const keyframe = track.keyframes[index];
    if (!keyframe) return track;
    const next = change(keyframe);
    if (next === keyframe) return track;
    const keyframes = track.keyframes.with(index, next);
    const isMoved = (["positions", "absent", "adjacency"] as const).some((part) => next[part] !== keyframe[part]);
    const isEnd = !liesBetween(track, index);
    return {
      ...track,
      keyframes,
      segments: isMoved && isEnd ? chooseAgain(track.segments, [index - 1, index]) : track.segments,
    };
  });
}

/** The scene with one transition changed, all parts of it. */
export function updateSegment(scene: Scene, index: number, change: (segment: Segment) => Segment): Scene {
  return updateTrack(scene, (track) => {
    const [first] = endsAround(track, index);
    const segment = track.segments[first];
    if (!segment) return track;
    const next = change(segment);
    if (next === segment) return track;
    // What a change leaves to auto is asked of every part.
    const segments = chooseAgain(track.segments.with(first, next), next.chosen ? [] : [index]);
    return { ...track, segments };
  });
}

/** The scene with who belongs together changed; auto chooses everywhere again. */
export function updateAdjacency(scene: Scene, change: (adjacency: AdjacencySpec) => AdjacencySpec): Scene {
  const adjacency = change(scene.adjacency);
  return adjacency === scene.adjacency ? scene : chooseAllAgain({ ...scene, adjacency });
}

/** Segments without what auto took before; the same list when none had taken anything. */
export function chooseAgain(segments: readonly Segment[], indices: Iterable<number>): readonly Segment[] {
  let next = segments;
  for (const index of indices) {
    const segment = segments[index];
    if (segment?.chosen) next = next.with(index, { ...segment, chosen: null });
  }
  return next;
}

export function chooseAllAgain(scene: Scene): Scene {
  return updateTrack(scene, (track) => {
    const segments = chooseAgain(track.segments, track.segments.keys());
    return segments === track.segments ? track : { ...track, segments };
  });
}
