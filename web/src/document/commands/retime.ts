import { reshapeKeyframe } from "../between";
import { updateKeyframe, updateTrack } from "../edit";
import { LIMITS, SHORTEST_TRANSITION, withinLimits } from "../limits";
import { roundTime, tidyTime } from "../round-time";
import { mainTrack, type Scene } from "../scene";
import type { Command } from "../store";

/** Move a keyframe in time, no nearer to its neighbors than a transition needs. */
export function retimeKeyframe(index: number, time: number): Command {
  return {
    label: "Retime keyframe",
    apply: (scene) => {
      const track = mainTrack(scene);
      const keyframe = track.keyframes[index];
      const next = track.keyframes[index + 1];
      if (!keyframe || !Number.isFinite(time)) return scene;
      const latest = (next ? next.time - SHORTEST_TRANSITION : LIMITS.seconds) - keyframe.hold;
      const clamped = clamp(time, earliest(scene, index), latest) ?? keyframe.time;
      if (clamped === keyframe.time) return scene;
      return withinLimits(
        scene,
        updateKeyframe(scene, index, (was) => ({ ...was, time: clamped })),
      );
    },
  };
}

/** Move a keyframe in time and all later ones along with it. */
export function rippleKeyframe(index: number, time: number): Command {
  return {
    label: "Retime keyframes",
    apply: (scene) => {
      const track = mainTrack(scene);
      const keyframe = track.keyframes[index];
      const last = track.keyframes.at(-1);
      if (!keyframe || !last || !Number.isFinite(time)) return scene;
      const latest = keyframe.time + LIMITS.seconds - (last.time + last.hold);
      const by = (clamp(time, earliest(scene, index), latest) ?? keyframe.time) - keyframe.time;
      if (by === 0) return scene;
      const keyframes = track.keyframes.map((was, i) => (i < index ? was : { ...was, time: tidyTime(was.time + by) }));
      return withinLimits(
        scene,
        updateTrack(scene, (was) => ({ ...was, keyframes })),
      );
    },
  };
}

/** @param hold how long the agents stand, seconds; at most until the next transition needs its time */
export function setHold(index: number, hold: number): Command {
  return {
    label: "Change hold",
    apply: (scene) => {
      const track = mainTrack(scene);
      const keyframe = track.keyframes[index];
      const next = track.keyframes[index + 1];
      if (!keyframe || !Number.isFinite(hold)) return scene;
      const most = (next ? next.time - SHORTEST_TRANSITION : LIMITS.seconds) - keyframe.time;
      const clamped = clamp(hold, 0, Math.max(0, most)) ?? 0;
      if (clamped === keyframe.hold) return scene;
      return withinLimits(
        scene,
        reshapeKeyframe(scene, index, (was) => ({ ...was, hold: clamped })),
      );
    },
  };
}

function earliest(scene: Scene, index: number): number {
  const before = mainTrack(scene).keyframes[index - 1];
  return before ? before.time + before.hold + SHORTEST_TRANSITION : 0;
}

/** Within bounds and exact to a millisecond; null where the bounds leave no room. */
function clamp(value: number, low: number, high: number): number | null {
  return low <= high ? tidyTime(Math.max(low, Math.min(high, roundTime(value)))) : null;
}
