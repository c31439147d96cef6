import { front as face } from "./document/front";
import type { Planning, SegmentPlan } from "./engine/api";
import type { Front } from "./panels/seen";
import { exchangedMotion } from "./playback/exchanged";

const plannings = new WeakMap<Planning, Planning>();

/** The show from the front, fetched when it is first asked for. */
export const front: Front = {
  ...face,
  planning(planning) {
    let seen = plannings.get(planning);
    if (!seen) {
      seen = exchangedPlanning(planning);
      plannings.set(planning, seen);
    }
    return seen;
  },
};

function exchangedPlanning(planning: Planning): Planning {
  if (planning.kind === "ready") return { ...planning, plan: exchangedPlan(planning.plan) };
  if (planning.kind === "planning") {
    const motion = planning.motion && exchangedMotion(planning.motion);
    return { ...planning, motion, stale: planning.stale && exchangedPlan(planning.stale) };
  }
  return planning;
}

function exchangedPlan(plan: SegmentPlan): SegmentPlan {
  return { ...plan, motion: exchangedMotion(plan.motion) };
}
