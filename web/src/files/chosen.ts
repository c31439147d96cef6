import { mainTrack, type Scene } from "../document/scene";
import type { Planning } from "../engine/api";
import { choiceOf } from "../engine/choice";

/** The scene with what auto took written down, so that whoever opens it sees the same motion. */
export function withChosen(scene: Scene, states: readonly Planning[]): Scene {
  const track = mainTrack(scene);
  const segments = track.segments.map((segment, index) => {
    const choice = choiceOf(states[index]);
    return segment.method === "auto" && segment.chosen === null && choice ? { ...segment, chosen: choice } : segment;
  });
  return { ...scene, tracks: [{ ...track, segments }, ...scene.tracks.slice(1)] };
}
