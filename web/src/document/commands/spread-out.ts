import { updateTrack } from "../edit";
import { withinLimits } from "../limits";
import type { Keyframe, Segment } from "../scene";
import type { Command } from "../store";

/** Keyframes within a transition at which everybody keeps apart, and what its parts then are. */
export interface Spread {
  readonly keyframes: readonly Keyframe[];
  readonly part: Segment;
}

/** The transition in parts, by way of formations in which those who were stuck have spread out. */
export function spreadOut(index: number, { keyframes, part }: Spread): Command {
  return {
    label: "Let them spread out",
    apply: (scene) =>
      withinLimits(
        scene,
        updateTrack(scene, (track) => {
          if (keyframes.length === 0 || !track.segments[index]) return track;
          return {
            ...track,
            keyframes: track.keyframes.toSpliced(index + 1, 0, ...keyframes),
            // Each part is its own: selections follow a part by which object it is.
            segments: track.segments.toSpliced(index, 1, ...[null, ...keyframes].map(() => ({ ...part }))),
          };
        }),
      ),
  };
}
