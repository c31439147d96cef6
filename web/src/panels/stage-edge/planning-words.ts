import { keyframeLabel } from "../../document/queries";
import type { Scene } from "../../document/scene";
import { formatCount } from "../../document/units";
import type { Planning } from "../../engine/api";

/** What is planned, and how far that is, 0..1. */
export interface PlanningWords {
  readonly what: string;
  readonly progress: number;
  readonly percent: string;
}

/** One transition says what its ribbon says; several are part of the whole show. */
export function planningWords(scene: Scene, segments: readonly Planning[], ofAll: number): PlanningWords {
  const planned = segments.flatMap((state, index) =>
    state.kind === "planning" ? [{ index, progress: state.progress }] : [],
  );
  const [first] = planned;
  if (!first || planned.length > 1) {
    const what = `${formatCount(planned.length)} transitions`;
    return { what, progress: ofAll, percent: `${Math.floor(ofAll * 100)} % of all` };
  }
  const { index, progress } = first;
  const what = `${keyframeLabel(scene, index)} → ${keyframeLabel(scene, index + 1)}`;
  return { what, progress, percent: `${Math.floor(progress * 100)} %` };
}
