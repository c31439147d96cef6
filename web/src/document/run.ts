import type { Selection } from "./selection";

/** Keyframes that follow one another, both ends included. */
export interface Run {
  readonly first: number;
  readonly last: number;
}

/** The run that is selected; null unless it has two keyframes at least. */
export function selectedRun(selection: Selection): Run | null {
  if (selection.kind !== "keyframe" || selection.anchor === undefined || selection.anchor === selection.index) {
    return null;
  }
  const { anchor, index } = selection;
  return { first: Math.min(anchor, index), last: Math.max(anchor, index) };
}

export function isInRun(run: Run | null, keyframe: number): boolean {
  return run !== null && keyframe >= run.first && keyframe <= run.last;
}
