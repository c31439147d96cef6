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
 * Two transitions as they are; or one of them twice: as it is, and the way everybody knows, or, where it goes that way
 * already, as the eigenbases do.
 */
export function startingSides(scene: Scene, [left, right]: readonly [number, number]): readonly [Side, Side] | null {
  const { segments } = mainTrack(scene);
  const [a, b] = [segments[left], segments[right]];
  if (!a || !b) return null;
  const other =
    left === right ? ({ ...b, method: a.method === "linear" ? "spectral" : "linear", chosen: null } as const) : b;
  return [
    { segment: left, spec: a, ties: "own", seating: null, counterpart: null },
    { segment: right, spec: other, ties: "own", seating: null, counterpart: null },
  ];
}
