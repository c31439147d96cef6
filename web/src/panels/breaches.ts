import type { Formation } from "../document/formation";
import type { Planning } from "../engine/api";
import { type Clash, ClashFinder } from "../stage/clashes";

/** Two agents that stand nearer than they may, and how near; meters. */
export type Breach = Readonly<Clash>;

/** How many agents stand too near to an obstacle in a keyframe, as far as the transitions beside it say. */
export function obstacleBreachCount(plannings: readonly Planning[], keyframe: number): number {
  const reported = (segment: number, end: 0 | 1): number => {
    const state = plannings[segment];
    const breaches = (state?.kind === "ready" && state.plan.report.breaches) || [];
    return breaches.filter((breach) => breach.end === end && "obstacle" in breach.other).length;
  };
  return Math.max(reported(keyframe, 0), reported(keyframe - 1, 1));
}

const known = new WeakMap<Formation, { readonly minimum: number; readonly breaches: readonly Breach[] }>();

/** Who stands too near in a formation, worst first; looked for once a formation and minimum distance. */
export function breachesOf(formation: Formation, minimum: number): readonly Breach[] {
  const before = known.get(formation);
  if (before?.minimum === minimum) return before.breaches;
  const finder = new ClashFinder();
  const heights = formation.heights && Float32Array.from(formation.heights);
  finder.find(Float32Array.from(formation.xy), minimum, heights);
  const breaches = finder.found.slice(0, finder.count).map((clash) => ({ ...clash }));
  known.set(formation, { minimum, breaches });
  return breaches;
}
