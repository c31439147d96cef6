import { FIRST_RECIPE } from "../../document/commands/assign";
import type { AssignmentSpec, Cost, Scene, Segment } from "../../document/scene";
import { mainTrack } from "../../document/scene";
import type { Engine } from "../../engine/api";

/** Who takes whose place from a transition's target on, and by what that was found. */
export interface Seating {
  readonly cost: Cost;
  /** By agent. */
  readonly slots: readonly number[];
}

/** The transition's own recipe under another cost. */
export function recipeOf({ assignment }: Segment, cost: Cost): AssignmentSpec {
  return { ...(assignment ?? FIRST_RECIPE), cost };
}

export type Seater = (scene: Scene, segment: number, cost: Cost) => Promise<Seating | null>;

/** Finds places, one question after the other: the engine is at one errand at a time. To keep them is no question. */
export function createSeater(find: Engine["findPlaces"]): Seater {
  let last: Promise<unknown> = Promise.resolve();
  return async (scene, segment, cost) => {
    const spec = mainTrack(scene).segments[segment];
    if (cost === "keep" || !spec) return null;
    const question = { segment, recipe: recipeOf(spec, cost), isFlipped: false, isPredicted: false };
    const found = last.then(() => find(scene, question, () => {}));
    last = found.catch(() => {});
    const places = await found;
    return places && { cost, slots: places.slots };
  };
}
