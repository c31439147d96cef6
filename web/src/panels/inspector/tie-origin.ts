import { adjacencyAt, handFactor, isCut } from "../../document/commands/ties";
import { groupAt, groupPaths, groupSet } from "../../document/groups";
import { groupLabel } from "../../document/queries";
import type { Scene } from "../../document/scene";
import type { TieList } from "../../engine/api";

/** What makes two agents belong together at a keyframe. */
export interface TieOrigin {
  readonly isCut: boolean;
  /** The factor by hand; 1 where there is none. */
  readonly byHand: number;
  readonly isByHand: boolean;
  /** The names of groups that tie the two, outer first. */
  readonly groups: readonly string[];
  /** All factors together, as the engine says; null until it has, and where the two are not tied. */
  readonly total: number | null;
}

export function tieOrigin(scene: Scene, keyframe: number, a: number, b: number, ties: TieList | null): TieOrigin {
  const adjacency = adjacencyAt(scene, keyframe);
  const tying = groupPaths(scene.groups).filter((path) => {
    const group = groupAt(scene.groups, path);
    if (!group || group.tieWeight === null) return false;
    const set = groupSet(group);
    return set.has(a) && set.has(b);
  });
  return {
    isCut: isCut(adjacency, a, b),
    byHand: handFactor(adjacency, a, b),
    isByHand: adjacency.ties.some(([one, other]) => (one === a && other === b) || (one === b && other === a)),
    groups: tying.map((path) => groupLabel(scene, path)),
    total: ties ? factorOf(ties, a, b) : null,
  };
}

/** Where a tie comes from, in words. */
export function originWords(origin: TieOrigin): string {
  const makers = [...(origin.isByHand ? ["You"] : []), ...origin.groups];
  if (origin.isCut) return "Cut by you";
  return makers.length > 0 ? makers.join(", ") : "Neighbors";
}

function factorOf(ties: TieList, a: number, b: number): number | null {
  const [low, high] = a < b ? [a, b] : [b, a];
  for (let tie = 0; tie < ties.factors.length; tie += 1) {
    if (ties.pairs[2 * tie] === low && ties.pairs[2 * tie + 1] === high) return ties.factors[tie] ?? null;
  }
  return null;
}
