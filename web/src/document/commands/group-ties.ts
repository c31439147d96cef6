import { LIMITS } from "../limits";
import { type AdjacencySpec, mainTrack } from "../scene";
import type { Command } from "../store";
import { changeScope, handFactor, isCut, type TieScope } from "./ties";

export type Pair = readonly [a: number, b: number];

/** The ties that run between two sets of agents at any of some keyframes, lower agent first, each once. */
export function pairsBetween(
  ties: readonly (ArrayLike<number> | null)[],
  one: ReadonlySet<number>,
  other: ReadonlySet<number>,
): readonly Pair[] {
  const found = new Map<string, Pair>();
  for (const pairs of ties) {
    for (let k = 0; pairs && k + 1 < pairs.length; k += 2) {
      const a = pairs[k] ?? 0;
      const b = pairs[k + 1] ?? 0;
      const isBetween = (one.has(a) && other.has(b)) || (one.has(b) && other.has(a));
      if (isBetween) found.set(`${a} ${b}`, [a, b]);
    }
  }
  return [...found.values()];
}

/** The pairs of two sets that are cut: no keyframe has their ties any more. */
export function cutsBetween(
  adjacency: AdjacencySpec,
  one: ReadonlySet<number>,
  other: ReadonlySet<number>,
): readonly Pair[] {
  return adjacency.cuts.filter(([a, b]) => (one.has(a) && other.has(b)) || (one.has(b) && other.has(a)));
}

/** What the person made of the ties between two groups: the most common factor, 0 where all are cut. */
export function factorBetween(adjacency: AdjacencySpec, pairs: readonly Pair[]): number {
  const tied = pairs.filter(([a, b]) => !isCut(adjacency, a, b));
  if (tied.length === 0) return 0;
  const counts = new Map<number, number>();
  for (const [a, b] of tied) {
    const factor = handFactor(adjacency, a, b);
    counts.set(factor, (counts.get(factor) ?? 0) + 1);
  }
  return [...counts].reduce((most, entry) => (entry[1] > most[1] ? entry : most))[0];
}

/**
 * Make ties between groups firmer or looser.
 *
 * @param factor multiplies each proposed tie; 0 cuts them, 1 leaves them as they are proposed
 */
export function weighTies(scope: TieScope, pairs: readonly Pair[], factor: number): Command {
  return {
    label: factor > 0 ? "Change ties between groups" : "Cut ties between groups",
    apply: (scene) =>
      changeScope(scene, scope, (was) => {
        const { agents } = mainTrack(scene);
        const known = pairs.filter(([a, b]) => a < b && agents[a] && agents[b]);
        const next = weighed(was, known, Math.min(factor, LIMITS.factor.max));
        return next.ties.length > LIMITS.ties || next.cuts.length > LIMITS.ties ? was : next;
      }),
  };
}

function weighed(was: AdjacencySpec, pairs: readonly Pair[], factor: number): AdjacencySpec {
  const touched = new Set(pairs.map(([a, b]) => `${a} ${b}`));
  const ties = was.ties.filter(([a, b]) => !touched.has(`${a} ${b}`));
  const cuts = was.cuts.filter(([a, b]) => !touched.has(`${a} ${b}`));
  if (!(factor > 0)) return { ...was, ties, cuts: [...cuts, ...pairs.map(([a, b]) => [a, b] as const)] };
  if (factor === 1) return { ...was, ties, cuts };
  return {
    ...was,
    ties: [...ties, ...pairs.map(([a, b]) => [a, b, Math.max(factor, LIMITS.factor.min)] as const)],
    cuts,
  };
}
