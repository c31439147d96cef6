import { chooseAgain, updateTrack } from "../edit";
import type { Command } from "../store";

/** Two agents take each other's places from a keyframe on: the ways that crossed before it no longer do. */
export function swapAgents(keyframe: number, a: number, b: number): Command {
  return {
    label: "Swap two agents",
    apply: (scene) =>
      updateTrack(scene, (track) => {
        if (a === b || !track.agents[a] || !track.agents[b] || !track.keyframes[keyframe]) return track;
        const keyframes = track.keyframes.map((was, index) => {
          if (index < keyframe) return was;
          const { positions } = was;
          const swapped = positions.with([
            [a, positions.point(b)],
            [b, positions.point(a)],
          ]);
          return { ...was, positions: swapped };
        });
        const touched = [...track.segments.keys()].filter((segment) => segment >= keyframe - 1);
        return { ...track, keyframes, segments: chooseAgain(track.segments, touched) };
      }),
  };
}
