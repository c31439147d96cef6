import { type Placement, placementAt } from "../../document/placement";
import { keyframeLabel } from "../../document/queries";
import { momentAt } from "../../document/timing";
import { formatCount } from "../../document/units";
import { useAtPlayhead } from "../at-playhead";
import { useStudio } from "../studio";

/** What Draw and Shape will do where the playhead is, and what to know of it beforehand. */
export interface PlacementAhead {
  readonly placement: Placement;
  /** The keyframe that is gone to first, because agents move; null when they stand. */
  readonly goesTo: string | null;
}

/** As the tools will do it: while agents move, at the nearest keyframe. */
export function usePlacement(): PlacementAhead {
  const { document } = useStudio();
  // As one number: a playhead that runs within a transition changes nothing here.
  const nearest = useAtPlayhead((time) => {
    const moment = momentAt(document.scene.value, time);
    return moment.kind === "moving" ? moment.nearest : -1;
  });
  const scene = document.scene.value;
  const isMoving = nearest.value >= 0;
  const keyframe = isMoving ? nearest.value : document.activeKeyframe.value;
  return {
    placement: placementAt(scene, keyframe, document.selection.value),
    goesTo: isMoving ? keyframeLabel(scene, keyframe) : null,
  };
}

/** Everything to know before `count` places (null: as many as fit) are filled; null when there is nothing. */
export function noteBefore(
  { placement, goesTo }: PlacementAhead,
  keyframeCount: number,
  count: number | null,
): string | null {
  const note = placement.kind === "place" ? placement.reason : additionNote(keyframeCount, count);
  return note && (goesTo === null ? note : `Goes to ${goesTo}. ${note}`);
}

/** What new agents do in a show of several keyframes. */
function additionNote(keyframeCount: number, count: number | null): string | null {
  if (keyframeCount < 2) return null;
  const who =
    count === null ? "New agents come" : count === 1 ? "1 new agent comes" : `${formatCount(count)} new agents come`;
  const where = count === 1 ? "place" : "places";
  return `${who} into every keyframe, at the same ${where}. To move those there are, go to a later keyframe.`;
}
