import { isDistance } from "../closest";
import { shortTime } from "./clock";
import { METHOD_WORDS, type TransitionState } from "./transition-state";

/** What a ribbon is called where it is not seen; `near` says how near whoever comes nearest comes. */
export function ribbonName(
  names: string,
  { status, plan, words, closest, progress }: TransitionState,
  near: string | null,
): string {
  if (!plan || progress !== null) return `Transition ${names}: ${words}`;
  const method = METHOD_WORDS[plan.report.choice.method];
  if (!near || !closest) return `Transition ${names}: ${method}`;
  const fares = status === "none" ? "" : `${status}, `;
  const where = status === "holds" ? "" : ` at ${shortTime(closest.time)}`;
  const nearness = isDistance(closest) ? `clearance ${near}` : near;
  return `Transition ${names}: ${method}, ${fares}${nearness}${where}`;
}
