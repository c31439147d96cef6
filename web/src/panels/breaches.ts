import type { Formation } from "../document/formation";
import { type Clash, ClashFinder } from "../stage/clashes";

/** Two agents that stand nearer than they may, and how near; meters. */
export type Breach = Readonly<Clash>;

const known = new WeakMap<Formation, { readonly minimum: number; readonly breaches: readonly Breach[] }>();

/** Who stands too near in a formation, worst first; looked for once a formation and minimum distance. */
export function breachesOf(formation: Formation, minimum: number): readonly Breach[] {
  const before = known.get(formation);
  if (before?.minimum === minimum) return before.breaches;
  const finder = new ClashFinder();
  finder.find(Float32Array.from(formation.xy), minimum);
  const breaches = finder.found.slice(0, finder.count).map((clash) => ({ ...clash }));
  known.set(formation, { minimum, breaches });
  return breaches;
}
