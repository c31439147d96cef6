import { expect, test } from "vitest";
import { emptyScene } from "../defaults";
import { addAgents } from "./agents";
import { cutsBetween, factorBetween, pairsBetween, weighTies } from "./group-ties";
import { addTie, WHOLE_SCENE } from "./ties";

const one = new Set([0, 1]);
const other = new Set([2, 3]);
/** Of two keyframes; 0–1 lies within one group, 3–4 leads elsewhere. */
const TIES = [Uint32Array.of(0, 1, 1, 2, 3, 4), null, Uint32Array.of(1, 2, 0, 3)];
const five = addAgents(Array.from({ length: 5 }, (_, agent) => [agent, 0] as const)).apply(emptyScene());

test("the ties between two groups are found at every keyframe, each once", () => {
  expect(pairsBetween(TIES, one, other)).toEqual([
    [1, 2],
    [0, 3],
  ]);
});

test("ties between groups are weighed, cut and brought back; other ties stay", () => {
  const pairs = pairsBetween(TIES, one, other);
  const before = addTie(WHOLE_SCENE, 0, 1, 5).apply(five);
  const firm = weighTies(WHOLE_SCENE, pairs, 20).apply(before);
  expect(firm.adjacency.ties).toEqual([
    [0, 1, 5],
    [1, 2, 20],
    [0, 3, 20],
  ]);
  expect(factorBetween(firm.adjacency, pairs)).toBe(20);

  const split = weighTies(WHOLE_SCENE, pairs, 0).apply(firm);
  expect(split.adjacency).toMatchObject({ ties: [[0, 1, 5]], cuts: pairs });
  expect(factorBetween(split.adjacency, pairs)).toBe(0);
  expect(cutsBetween(split.adjacency, other, one)).toEqual(pairs);

  expect(weighTies(WHOLE_SCENE, pairs, 1).apply(split).adjacency).toEqual(before.adjacency);
});
