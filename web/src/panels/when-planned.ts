import { effect, untracked } from "@preact/signals";
import type { Planning } from "../engine/api";
import type { ActionParts } from "./doing";

/** Whether what the stage shows of a transition is the motion of the scene as it is, or nothing better is to come. */
function isSettled(state: Planning | undefined): boolean {
  return state?.kind !== "planning" || (state.isCurrent && state.motion !== null);
}

/**
 * Runs something as soon as a transition moves as it is going to: at once, where it does already.
 *
 * @param given what follows when the scene changes before
 * @returns whether it ran at once
 */
export function whenPlanned(
  { document, planner }: Pick<ActionParts, "document" | "planner">,
  segment: number,
  run: () => void,
  given: () => void,
): boolean {
  const scene = document.scene.peek();
  const isOver = () => document.scene.value !== scene;
  const isThere = () => isSettled(planner.segments.value[segment]);
  let hasRun = false;
  let stop: (() => void) | null = null;
  stop = effect(() => {
    if (hasRun || (!isOver() && !isThere())) return;
    hasRun = true;
    untracked(isOver() ? given : run);
    stop?.();
  });
  if (hasRun) stop();
  return hasRun;
}
