import type { MethodName } from "../../document/scene";
import type { Planning, SegmentPlan } from "../../engine/api";
import { type Status, status } from "../status";

export const METHOD_WORDS: Readonly<Record<MethodName, string>> = {
  auto: "Auto",
  spectral: "Spectral",
  shared: "Shared",
  polar: "Polar",
  linear: "Linear",
};

/** What a ribbon says of its transition. */
export interface TransitionState {
  readonly status: Status;
  /** Null until the engine has said. */
  readonly plan: SegmentPlan | null;
  /** The words beside the number: the method, "Planning, 62 %", "Canceled", "Not planned". */
  readonly words: string;
  readonly isPlanning: boolean;
}

export function transitionState(planning: Planning | undefined, minimumDistance: number): TransitionState {
  if (!planning) return { status: "none", plan: null, words: "Planning", isPlanning: true };
  switch (planning.kind) {
    case "ready":
      return known(planning.plan, minimumDistance, METHOD_WORDS[planning.plan.report.choice.method], false);
    case "planning": {
      const words = `Planning, ${Math.floor(planning.progress * 100)} %`;
      if (planning.stale) return known(planning.stale, minimumDistance, words, true);
      return { status: "none", plan: null, words, isPlanning: true };
    }
    case "canceled":
      return { status: "none", plan: null, words: "Canceled", isPlanning: false };
    case "failed":
      return { status: "none", plan: null, words: "Not planned", isPlanning: false };
  }
}

function known(plan: SegmentPlan, minimumDistance: number, words: string, isPlanning: boolean): TransitionState {
  const distance = plan.report.clearance?.distance ?? null;
  return { status: status(distance, minimumDistance), plan, words, isPlanning };
}
