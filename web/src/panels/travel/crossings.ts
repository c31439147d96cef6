import { barycenterOf } from "../../document/formation";
import { keyframeLabel } from "../../document/queries";
import { mainTrack, type Scene } from "../../document/scene";
import { endsAround } from "../../document/stretches";
import { crosses, curveThrough, followed } from "../../shapes/travel";

/** A sentence for each path that crosses itself: it is followed all the same. */
export function crossings(scene: Scene): readonly string[] {
  const track = mainTrack(scene);
  return track.segments.flatMap(({ path }, index) => {
    const ends = endsAround(track, index);
    const [from, to] = ends.map((end) => track.keyframes[end]?.positions);
    // The parts of a transition have one path.
    if (!path || !from || !to || ends[0] !== index) return [];
    if (!crosses(curveThrough(followed(path, barycenterOf(from), barycenterOf(to))))) return [];
    return `The path from ${keyframeLabel(scene, index)} crosses itself: they pass there twice.`;
  });
}
