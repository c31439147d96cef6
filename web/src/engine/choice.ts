import type { Choice } from "../document/scene";
import type { Planning } from "./api";

/** What a transition's motion was made by; null until it is known. */
export function choiceOf(state: Planning | undefined): Choice | null {
  return state?.kind === "ready" ? state.plan.report.choice : null;
}
