import type { Formation } from "../document/formation";
import type { TieList } from "../engine/api";
import { clamp } from "./spacing";

/** Ties of one look are stroked together. */
const LOOKS = 16;

/** When a tie of a transition is drawn: throughout, or only toward the keyframe that has it. */
export type TiePhase = "both" | "leaving" | "coming";

/** Ties that look alike: same phase, width and alpha. */
export interface TieBundle {
  readonly phase: TiePhase;
  /** CSS pixels. */
  readonly width: number;
  readonly alpha: number;
  /** a0, b0, a1, b1, … */
  readonly pairs: Uint32Array;
}

/** How strong a weight looks, 0 (0.1×) to 1 (100×). */
export function tieStrength(weight: number): number {
  return clamp((Math.log10(weight) + 1) / 3, 0, 1);
}

export function tieWidth(strength: number): number {
  return Math.min(0.5 + 3 * strength * strength, 3.2);
}

export function tieAlpha(strength: number): number {
  return 0.07 + 0.55 * strength * strength;
}

/** A tie by hand weighs its factor; a proposed one the less the longer it is, compared with `spacing` in meters. */
export function shownWeight(factor: number, length: number, spacing: number): number {
  if (factor !== 1) return clamp(factor, 0.1, 100);
  return length > 0 ? clamp((1.25 * spacing) / length, 0.1, 1) : 1;
}

/** Ties that a transition shows, bundled by look; `to` is null at a keyframe that stands alone. */
export function bundleTies(
  from: { readonly ties: TieList; readonly formation: Formation },
  to: { readonly ties: TieList; readonly formation: Formation } | null,
  spacing: number,
): TieBundle[] {
  const bundles = new Map<string, { phase: TiePhase; look: number; pairs: number[] }>();
  const put = (phase: TiePhase, a: number, b: number, weight: number) => {
    const look = Math.round(tieStrength(weight) * LOOKS);
    const key = `${phase} ${look}`;
    let bundle = bundles.get(key);
    if (!bundle) {
      bundle = { phase, look, pairs: [] };
      bundles.set(key, bundle);
    }
    bundle.pairs.push(a, b);
  };
  const later = new Map<number, number>();
  const count = from.formation.agentCount;
  if (to && to.ties !== from.ties) {
    eachTie(to.ties, to.formation, spacing, (a, b, weight) => later.set(a * count + b, weight));
  }
  eachTie(from.ties, from.formation, spacing, (a, b, weight) => {
    const key = a * count + b;
    const there = later.get(key);
    later.delete(key);
    if (there === undefined) put(to && to.ties !== from.ties ? "leaving" : "both", a, b, weight);
    // The geometric mean looks halfway, as strength is logarithmic.
    else put("both", a, b, Math.sqrt(weight * there));
  });
  for (const [key, weight] of later) put("coming", Math.floor(key / count), key % count, weight);
  return [...bundles.values()]
    .sort((x, y) => x.look - y.look)
    .map(({ phase, look, pairs }) => ({
      phase,
      width: tieWidth(look / LOOKS),
      alpha: tieAlpha(look / LOOKS),
      pairs: Uint32Array.from(pairs),
    }));
}

/** Ties of any bundle between two agents of one set, for its hull. */
export function pairsWithin(bundles: readonly TieBundle[], agents: Uint32Array): Uint32Array {
  const isIn = new Set(agents);
  const pairs: number[] = [];
  for (const bundle of bundles) {
    for (let k = 0; k + 1 < bundle.pairs.length; k += 2) {
      const a = bundle.pairs[k] ?? 0;
      const b = bundle.pairs[k + 1] ?? 0;
      if (isIn.has(a) && isIn.has(b)) pairs.push(a, b);
    }
  }
  return Uint32Array.from(pairs);
}

/** Three agents all tied to each other, once each: a0, b0, c0, a1, … */
export function trianglesOf(pairs: Uint32Array): Uint32Array {
  const later = new Map<number, Set<number>>();
  for (let k = 0; k + 1 < pairs.length; k += 2) {
    const a = Math.min(pairs[k] ?? 0, pairs[k + 1] ?? 0);
    const b = Math.max(pairs[k] ?? 0, pairs[k + 1] ?? 0);
    const known = later.get(a);
    if (known) known.add(b);
    else later.set(a, new Set([b]));
  }
  const triangles: number[] = [];
  for (const [a, others] of later) {
    for (const b of others) {
      for (const c of later.get(b) ?? []) if (others.has(c)) triangles.push(a, b, c);
    }
  }
  return Uint32Array.from(triangles);
}

function eachTie(
  ties: TieList,
  formation: Formation,
  spacing: number,
  visit: (a: number, b: number, weight: number) => void,
): void {
  for (let tie = 0; tie < ties.factors.length; tie += 1) {
    const a = ties.pairs[2 * tie] ?? 0;
    const b = ties.pairs[2 * tie + 1] ?? 0;
    const length = Math.hypot(formation.x(a) - formation.x(b), formation.y(a) - formation.y(b));
    // A tie of a scene that has changed since may name an agent that is gone.
    if (!Number.isNaN(length)) visit(a, b, shownWeight(ties.factors[tie] ?? 1, length, spacing));
  }
}
