import { effect, untracked } from "@preact/signals";
import type { ActionParts } from "./doing";

/**
 * Runs something as soon as a transition is planned, or will not be: at once, where that is known already.
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
  const isThere = () => planner.segments.value[segment]?.kind !== "planning";
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
