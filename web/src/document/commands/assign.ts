import { updateKeyframe, updateSegment } from "../edit";
import { type AssignmentSpec, mainTrack, type Scene } from "../scene";
import type { Command } from "../store";
import { takePlaces } from "./swap";

/** Everybody keeps their place: where nobody has said anything yet. */
export const FIRST_RECIPE: AssignmentSpec = { cost: "keep", lambda: 0.9, locks: [], keepGroups: false };

/**
 * Who goes where in a transition: from its target on, every agent takes the place of `slots[agent]`.
 *
 * The places are then the agents' own, so a lock of the recipe that is kept reads: an agent on its own place.
 *
 * @param rest what becomes of those who take the places of the absent at the target: they leave, stay where they were, or wait there
 */
export function assignPlaces(
  segment: number,
  slots: ArrayLike<number>,
  recipe: AssignmentSpec,
  rest: "leave" | "stay" | "bench" = "leave",
): Command {
  return {
    label: "Assign places",
    apply: (scene) => {
      const locks = recipe.locks.map(([agent]) => [agent, agent] as const);
      const seated = takePlaces(segment + 1, slots).apply(scene);
      const kept = rest === "leave" ? seated : keepRest(seated, segment, rest === "stay");
      return updateSegment(kept, segment, (was) => ({
        ...was,
        assignment: { ...recipe, locks },
      }));
    },
  };
}

/** Nobody is absent from the target of a transition: whoever was stays where they come from, or waits at the place they got. */
function keepRest(scene: Scene, segment: number, areStaying: boolean): Scene {
  const before = mainTrack(scene).keyframes[segment]?.positions;
  return updateKeyframe(scene, segment + 1, (was) => {
    if (was.absent.length === 0 || !before) return was;
    const stays = was.absent.map((agent) => [agent, before.point(agent)] as const);
    return { ...was, positions: areStaying ? was.positions.with(stays) : was.positions, absent: [] };
  });
}
