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
  /** 0..1 while it is planned, else null. */
  readonly progress: number | null;
}

export function transitionState(planning: Planning | undefined, minimumDistance: number): TransitionState {
  if (!planning) return { status: "none", plan: null, words: "Planning", progress: 0 };
  switch (planning.kind) {
    case "ready":
      return known(planning.plan, minimumDistance, METHOD_WORDS[planning.plan.report.choice.method], null);
    case "planning": {
      const words = `Planning, ${Math.floor(planning.progress * 100)} %`;
      if (planning.stale) return known(planning.stale, minimumDistance, words, planning.progress);
      return { status: "none", plan: null, words, progress: planning.progress };
    }
    case "canceled":
      return { status: "none", plan: null, words: "Canceled", progress: null };
    case "failed":
      return { status: "none", plan: null, words: "Not planned", progress: null };
  }
}

function known(plan: SegmentPlan, minimumDistance: number, words: string, progress: number | null): TransitionState {
  const distance = plan.report.clearance?.distance ?? null;
  return { status: status(distance, minimumDistance), plan, words, progress };
}
