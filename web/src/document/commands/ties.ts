import { updateAdjacency, updateKeyframe, updateTrack } from "../edit";
import { LIMITS } from "../limits";
import { type AdjacencySpec, mainTrack, type Scene } from "../scene";
import type { Command } from "../store";

/** Where a tie is edited: in the whole show (what belongs together stays so), or at one keyframe. */
export type TieScope = { readonly kind: "scene" } | { readonly kind: "keyframe"; readonly index: number };

export const WHOLE_SCENE: TieScope = { kind: "scene" };

/** The factor of a tie drawn by hand: as firm as a group's ties in paper A, figure 6. */
export const DRAWN_TIE_FACTOR = 10;

/** Tie two agents; a cut between them is mended. */
export function addTie(scope: TieScope, a: number, b: number, factor: number = DRAWN_TIE_FACTOR): Command {
  return { label: "Add tie", apply: (scene) => changeScope(scene, scope, (was) => withTie(scene, was, a, b, factor)) };
}

/** @param factor multiplies the proposed tie, or makes one where none is proposed */
export function setTieFactor(scope: TieScope, a: number, b: number, factor: number): Command {
  return {
    label: "Change tie weight",
    apply: (scene) => changeScope(scene, scope, (was) => withTie(scene, was, a, b, factor)),
  };
}

/** Back to what is proposed: neither firmer nor cut by hand. */
export function resetTie(scope: TieScope, a: number, b: number): Command {
  return { label: "Reset tie", apply: (scene) => changeScope(scene, scope, (was) => untouched(was, a, b)) };
}

/** These two do not belong together, whatever is proposed. */
export function cutTie(scope: TieScope, a: number, b: number): Command {
  return {
    label: "Cut tie",
    apply: (scene) =>
      changeScope(scene, scope, (was) => {
        if (!isPair(scene, a, b) || isCut(was, a, b) || was.cuts.length >= LIMITS.ties) return was;
        const clean = untouched(was, a, b);
        return { ...clean, cuts: [...clean.cuts, [Math.min(a, b), Math.max(a, b)]] };
      }),
  };
}

/** Take a cut back. */
export function restoreTie(scope: TieScope, a: number, b: number): Command {
  return {
    label: "Restore tie",
    apply: (scene) => changeScope(scene, scope, (was) => (isCut(was, a, b) ? untouched(was, a, b) : was)),
  };
}

/** Where the ties start from: proposed by the positions, or none but those by hand. */
export function setBase(scope: TieScope, base: AdjacencySpec["base"]): Command {
  return {
    label: "Change proposed ties",
    apply: (scene) => changeScope(scene, scope, (was) => (was.base === base ? was : { ...was, base })),
  };
}

export function setWeights(scope: TieScope, weights: AdjacencySpec["weights"]): Command {
  return {
    label: "Change tie weights",
    apply: (scene) => changeScope(scene, scope, (was) => (was.weights === weights ? was : { ...was, weights })),
  };
}

/** A keyframe with ties of its own belongs to the show's again. */
export function dropOwnTies(index: number): Command {
  return {
    label: "Use the show's ties",
    apply: (scene) =>
      updateKeyframe(scene, index, (was) => (was.adjacency === null ? was : { ...was, adjacency: null })),
  };
}

/** The factor by hand, 1 where there is none. */
export function handFactor(adjacency: AdjacencySpec, a: number, b: number): number {
  return adjacency.ties.find((tie) => joins(tie, a, b))?.[2] ?? 1;
}

export function isCut(adjacency: AdjacencySpec, a: number, b: number): boolean {
  return adjacency.cuts.some((cut) => joins(cut, a, b));
}

/** Who belongs together at a keyframe: its own say, or else the scene's. */
export function adjacencyAt(scene: Scene, keyframe: number): AdjacencySpec {
  return mainTrack(scene).keyframes[keyframe]?.adjacency ?? scene.adjacency;
}

/** An edit of the whole show reaches keyframes with ties of their own too. */
export function changeScope(scene: Scene, scope: TieScope, change: (adjacency: AdjacencySpec) => AdjacencySpec): Scene {
  if (scope.kind === "keyframe") {
    return updateKeyframe(scene, scope.index, (was) => {
      const adjacency = was.adjacency ?? scene.adjacency;
      const next = change(adjacency);
      return next === adjacency ? was : { ...was, adjacency: next };
    });
  }
  const keyframes = mainTrack(scene).keyframes.map((was) => {
    const adjacency = was.adjacency && change(was.adjacency);
    return adjacency === was.adjacency ? was : { ...was, adjacency };
  });
  const isSame = keyframes.every((keyframe, i) => keyframe === mainTrack(scene).keyframes[i]);
  const next = isSame ? scene : updateTrack(scene, (track) => ({ ...track, keyframes }));
  return updateAdjacency(next, change);
}

function withTie(scene: Scene, was: AdjacencySpec, a: number, b: number, factor: number): AdjacencySpec {
  if (!isPair(scene, a, b) || !(factor > 0) || was.ties.length >= LIMITS.ties) return was;
  const clamped = Math.max(LIMITS.factor.min, Math.min(LIMITS.factor.max, factor));
  if (!isCut(was, a, b) && was.ties.some((tie) => joins(tie, a, b) && tie[2] === clamped)) return was;
  const clean = untouched(was, a, b);
  return { ...clean, ties: [...clean.ties, [Math.min(a, b), Math.max(a, b), clamped]] };
}

function untouched(was: AdjacencySpec, a: number, b: number): AdjacencySpec {
  const ties = was.ties.filter((tie) => !joins(tie, a, b));
  const cuts = was.cuts.filter((cut) => !joins(cut, a, b));
  const isSame = ties.length === was.ties.length && cuts.length === was.cuts.length;
  return isSame ? was : { ...was, ties, cuts };
}

function joins(tie: readonly [number, number, ...number[]], a: number, b: number): boolean {
  return (tie[0] === a && tie[1] === b) || (tie[0] === b && tie[1] === a);
}

function isPair(scene: Scene, a: number, b: number): boolean {
  const agents = mainTrack(scene).agents;
  return a !== b && agents[a] !== undefined && agents[b] !== undefined;
}
