import { updateSegment } from "../edit";
import type { AssignmentSpec } from "../scene";
import type { Command } from "../store";
import { takePlaces } from "./swap";

/** Everybody keeps their place: where nobody has said anything yet. */
export const FIRST_RECIPE: AssignmentSpec = { cost: "keep", lambda: 0.9, locks: [], keepGroups: false };

/**
 * Who goes where in a transition: from its target on, every agent takes the place of `slots[agent]`.
 *
 * The places are then the agents' own, so a lock of the recipe that is kept reads: an agent on its own place.
 */
export function assignPlaces(segment: number, slots: ArrayLike<number>, recipe: AssignmentSpec): Command {
  return {
    label: "Assign places",
    apply: (scene) => {
      const locks = recipe.locks.map(([agent]) => [agent, agent] as const);
      return updateSegment(takePlaces(segment + 1, slots).apply(scene), segment, (was) => ({
        ...was,
        assignment: { ...recipe, locks },
      }));
    },
  };
}
