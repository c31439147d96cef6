import { mainTrack, type Scene } from "../../document/scene";
import type { Selection } from "../../document/selection";
import { momentAt } from "../../document/timing";
import type { Side } from "./sides";

/** The transition that a comparison is about when nobody says which: the selected one, else the one at the playhead. */
export function transitionAtHand(scene: Scene, selection: Selection, time: number): number {
  if (selection.kind === "transition") return selection.index;
  const moment = momentAt(scene, time);
  const last = mainTrack(scene).segments.length - 1;
  return Math.min(moment.kind === "moving" ? moment.segment : moment.keyframe, last);
}

/**
 * Transitions as they are; one that comes again, the way everybody knows, or, where it goes that way already, as the
 * eigenbases do. Null where one is not there.
 */
export function startingSides(scene: Scene, which: readonly number[]): readonly Side[] | null {
  const { segments } = mainTrack(scene);
  const sides = which.flatMap((segment, index): Side[] => {
    const own = segments[segment];
    if (!own) return [];
    const other = { ...own, method: own.method === "linear" ? "spectral" : "linear", chosen: null } as const;
    const spec = which.indexOf(segment) < index ? other : own;
    return [{ segment, spec, ties: "own", seating: null, counterpart: null }];
  });
  return sides.length === which.length ? sides : null;
}
