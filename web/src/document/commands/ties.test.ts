import { expect, test } from "vitest";
import { emptyScene } from "../defaults";
import { Formation, type Point } from "../formation";
import { mainTrack, type Scene } from "../scene";
import { addAgents } from "./agents";
import { addKeyframe } from "./keyframes";
import {
  addTie,
  adjacencyAt,
  cutTie,
  dropOwnTies,
  handFactor,
  isCut,
  resetTie,
  restoreTie,
  setTieFactor,
  WHOLE_SCENE,
} from "./ties";

const PLACES: readonly Point[] = [
  [0, 0],
  [4, 0],
  [0, 4],
];

function twoKeyframes(): Scene {
  return addKeyframe(0, Formation.from(PLACES)).apply(addAgents(PLACES).apply(emptyScene()));
}

test("a tie by hand is firm and is written lower agent first", () => {
  const scene = addTie(WHOLE_SCENE, 2, 0).apply(twoKeyframes());
  expect(scene.adjacency.ties).toEqual([[0, 2, 10]]);
  expect(handFactor(scene.adjacency, 2, 0)).toBe(10);
});

test("a cut forgets the weight, and mending it leaves what is proposed", () => {
  const tied = setTieFactor(WHOLE_SCENE, 0, 1, 5).apply(twoKeyframes());
  const cut = cutTie(WHOLE_SCENE, 1, 0).apply(tied);
  expect(cut.adjacency).toMatchObject({ ties: [], cuts: [[0, 1]] });
  expect(restoreTie(WHOLE_SCENE, 0, 1).apply(cut).adjacency).toMatchObject({ ties: [], cuts: [] });
  expect(addTie(WHOLE_SCENE, 0, 1).apply(cut).adjacency).toMatchObject({ ties: [[0, 1, 10]], cuts: [] });
});

test("resetting an untouched tie changes nothing", () => {
  const scene = twoKeyframes();
  expect(resetTie(WHOLE_SCENE, 0, 1).apply(scene)).toBe(scene);
  expect(restoreTie(WHOLE_SCENE, 0, 1).apply(scene)).toBe(scene);
});

test("a tie of one keyframe leaves the others as they were", () => {
  const scene = addTie({ kind: "keyframe", index: 1 }, 0, 1).apply(addTie(WHOLE_SCENE, 1, 2).apply(twoKeyframes()));
  expect(adjacencyAt(scene, 0).ties).toEqual([[1, 2, 10]]);
  expect(adjacencyAt(scene, 1).ties).toEqual([
    [1, 2, 10],
    [0, 1, 10],
  ]);
  expect(dropOwnTies(1).apply(scene).tracks[0]?.keyframes[1]?.adjacency).toBeNull();
});

test("what belongs together in the whole show does so at a keyframe with ties of its own", () => {
  const own = cutTie({ kind: "keyframe", index: 1 }, 0, 1).apply(twoKeyframes());
  const scene = addTie(WHOLE_SCENE, 1, 2).apply(own);
  expect(handFactor(adjacencyAt(scene, 1), 1, 2)).toBe(10);
  expect(isCut(adjacencyAt(scene, 1), 0, 1)).toBe(true);
  expect(isCut(adjacencyAt(scene, 0), 0, 1)).toBe(false);
});

test("a weight stays within what the format holds", () => {
  const scene = setTieFactor(WHOLE_SCENE, 0, 1, 1e9).apply(twoKeyframes());
  expect(handFactor(scene.adjacency, 0, 1)).toBe(1e6);
  expect(setTieFactor(WHOLE_SCENE, 0, 1, Number.NaN).apply(scene)).toBe(scene);
});

test("new ties make auto choose again", () => {
  const chosen = { method: "polar", order: "greedy", alignment: "pca", sharing: 0.5 } as const;
  const scene = twoKeyframes();
  const track = mainTrack(scene);
  const saved = { ...scene, tracks: [{ ...track, segments: track.segments.map((s) => ({ ...s, chosen })) }] };
  expect(mainTrack(addTie(WHOLE_SCENE, 0, 1).apply(saved)).segments[0]?.chosen).toBeNull();
});
