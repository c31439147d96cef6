import { type Choice, mainTrack, type Scene } from "../document/scene";
import type { Planning } from "../engine/api";

function choiceOf(state: Planning | undefined): Choice | null {
  return state?.kind === "ready" ? state.plan.report.choice : null;
}

/** The scene with what auto took written down, so that whoever opens it sees the same motion. */
export function withChosen(scene: Scene, states: readonly Planning[]): Scene {
  const track = mainTrack(scene);
  const segments = track.segments.map((segment, index) => {
    const choice = choiceOf(states[index]);
    return segment.method === "auto" && segment.chosen === null && choice ? { ...segment, chosen: choice } : segment;
  });
  return { ...scene, tracks: [{ ...track, segments }, ...scene.tracks.slice(1)] };
}
