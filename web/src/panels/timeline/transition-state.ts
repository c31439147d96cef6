import type { MethodName } from "../../document/scene";
import type { Approach, Planning, SegmentPlan } from "../../engine/api";
import { type Closest, closestOf } from "../closest";
import { type Status, status } from "../status";

export const METHOD_WORDS: Readonly<Record<MethodName, string>> = {
  auto: "Auto",
  spectral: "Spectral",
  shared: "Shared",
  polar: "Polar",
  linear: "Linear",
  crowd: "Crowd",
};

/** What a ribbon says of its transition. */
export interface TransitionState {
  readonly status: Status;
  /** Null until the engine has said. */
  readonly plan: SegmentPlan | null;
  /** The words beside the number: the method, "Planning, 62 %", "Canceled", "Not planned". */
  readonly words: string;
  /** What comes nearest in the plan; null where nobody meets anything. */
  readonly closest: Closest | null;
  /** The nearest meeting of the motion before avoidance, where that was a clash. */
  readonly before: Approach | null;
  /** 0..1 while it is planned, else null. */
  readonly progress: number | null;
}

export function transitionState(planning: Planning | undefined, minimumDistance: number): TransitionState {
  if (!planning) return unknown("Planning", 0);
  switch (planning.kind) {
    case "ready":
      return known(planning.plan, minimumDistance, METHOD_WORDS[planning.plan.report.choice.method], null);
    case "planning": {
      const words = `Planning, ${Math.floor(planning.progress * 100)} %`;
      if (planning.stale) return known(planning.stale, minimumDistance, words, planning.progress);
      return unknown(words, planning.progress);
    }
    case "canceled":
      return unknown("Canceled", null);
    case "failed":
      return unknown("Not planned", null);
  }
}

function known(plan: SegmentPlan, minimumDistance: number, words: string, progress: number | null): TransitionState {
  const { guideClearance } = plan.report;
  const closest = closestOf(plan.report);
  const before = guideClearance && guideClearance.distance < minimumDistance ? guideClearance : null;
  return { status: status(closest?.distance ?? null, minimumDistance), plan, words, closest, before, progress };
}

function unknown(words: string, progress: number | null): TransitionState {
  return { status: "none", plan: null, words, closest: null, before: null, progress };
}
