import type { Units } from "../../document/scene";
import type { EngineProblem, Planning, SegmentPlan } from "../../engine/api";
import { closestOf, closestWords } from "../closest";
import { type Status, status } from "../status";

/** What the inspector says of a transition's motion. */
export interface PlanningView {
  readonly status: Status;
  /** On the pill: the least distance, or how far planning is. */
  readonly words: string;
  /** The motion shown, of the scene as it is or, while planning, as it was. */
  readonly plan: SegmentPlan | null;
  /** The motion shown is of the scene as it was. */
  readonly isFormer: boolean;
  readonly isCanceled: boolean;
  readonly problem: EngineProblem | null;
}

export function planningView(planning: Planning | undefined, minimum: number, units: Units): PlanningView {
  const quiet = { status: "none", plan: null, isFormer: false, isCanceled: false, problem: null } as const;
  switch (planning?.kind) {
    case undefined:
      return { ...quiet, words: "Planning" };
    case "planning": {
      const words = `Planning, ${Math.floor(planning.progress * 100)} %`;
      return { ...quiet, words, plan: planning.stale, isFormer: planning.stale !== null };
    }
    case "canceled":
      return { ...quiet, words: "Canceled", isCanceled: true };
    case "failed":
      return { ...quiet, words: "Not planned", problem: planning.problem };
    case "ready": {
      const { report } = planning.plan;
      const closest = closestOf(report);
      return {
        ...quiet,
        status: status(closest?.distance ?? null, minimum),
        words: closest ? closestWords(report, closest, units) : "",
        plan: planning.plan,
      };
    }
  }
}
