import { mainTrack, type Scene } from "../../document/scene";

/** The next thing a person new to an empty stage does. */
export type HintStep = "draw" | "next" | "play";

export const HINT_STEPS: readonly HintStep[] = ["draw", "next", "play"];

/** Agents first, then a second formation of them, then the show. */
export function hintStep(scene: Scene): HintStep {
  const { agents, keyframes } = mainTrack(scene);
  const [first] = keyframes;
  if (agents.length === 0 || !first) return "draw";
  const hasMoved = keyframes.some((keyframe) =>
    keyframe.positions.xy.some((value, i) => value !== first.positions.xy[i]),
  );
  return hasMoved ? "play" : "next";
}
