import { updateKeyframe, updateTrack } from "../edit";
import { clampCoordinate } from "../limits";
import { mainTrack, type Scene, type Segment } from "../scene";
import type { Command } from "../store";

/** Lift some agents at one keyframe, meters; down where negative. A plane scene gets heights by it. */
export function liftAgents(keyframe: number, agents: ReadonlySet<number>, by: number, label = "Lift agents"): Command {
  return { label, apply: (scene) => putHeights(scene, keyframe, agents, (height) => height + by) };
}

/** Put one agent at an exact height, meters. */
export function setHeight(keyframe: number, agent: number, height: number): Command {
  return { label: "Lift agent", apply: (scene) => putHeights(scene, keyframe, new Set([agent]), () => height) };
}

/**
 * The scene with heights in all keyframes or in none: in none when everybody stands on the ground in each.
 * The same scene when that is so already.
 */
export function settleHeights(scene: Scene): Scene {
  const formations = mainTrack(scene).keyframes.map((keyframe) => keyframe.positions);
  const isPlane = formations.every(({ heights }) => heights?.every((height) => height === 0) ?? true);
  const isSettled = formations.every(({ heights }) => (heights === null) === isPlane);
  if (isSettled) return scene;
  return updateTrack(scene, (track) => ({
    ...track,
    keyframes: track.keyframes.map((keyframe) => {
      const { positions } = keyframe;
      if ((positions.heights === null) === isPlane) return keyframe;
      const heights = isPlane ? null : new Float64Array(positions.agentCount);
      return { ...keyframe, positions: positions.withHeights(heights) };
    }),
    segments: isPlane ? track.segments.map(onGround) : track.segments,
  }));
}

/** A path in a plane scene has no heights. */
function onGround(segment: Segment): Segment {
  return segment.path?.some((point) => point.length > 2)
    ? { ...segment, path: segment.path.map(([x, y]) => [x, y] as const) }
    : segment;
}

function putHeights(
  scene: Scene,
  keyframe: number,
  agents: ReadonlySet<number>,
  change: (height: number) => number,
): Scene {
  const next = updateKeyframe(scene, keyframe, (was) => {
    const { positions } = was;
    const heights = Float64Array.from({ length: positions.agentCount }, (_, agent) => {
      const height = positions.height(agent);
      const changed = agents.has(agent) ? change(height) : height;
      // A micrometer is what a link keeps: sums of steps come out round.
      return Number.isFinite(changed) ? clampCoordinate(Math.round(changed * 1e6) / 1e6 + 0) : height;
    });
    const isSame = heights.every((height, agent) => height === positions.height(agent));
    return isSame ? was : { ...was, positions: positions.withHeights(heights) };
  });
  return next === scene ? scene : settleHeights(next);
}
