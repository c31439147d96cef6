import { expect, test } from "vitest";
import { emptyScene } from "../defaults";
import type { Scene } from "../scene";
import { addAgents } from "./agents";
import { tiesTo, tieToObstacle, untieFromObstacle } from "./obstacle-ties";
import { addObstacle } from "./obstacles";
import { WHOLE_SCENE } from "./ties";

const scene: Scene = [
  addAgents([
    [0, 0],
    [1, 0],
  ]),
  addObstacle({ kind: "circle", center: [5, 0], radius: 1 }),
].reduce((was, command) => command.apply(was), emptyScene());

test("an agent is tied to an obstacle, more firmly, and no more", () => {
  const tied = tieToObstacle(WHOLE_SCENE, 1, 0).apply(scene);
  expect(tiesTo(tied, 0)).toEqual([[1, 1]]);
  const firmer = tieToObstacle(WHOLE_SCENE, 1, 0, 10).apply(tied);
  expect(tiesTo(firmer, 0)).toEqual([[1, 10]]);
  expect(tiesTo(untieFromObstacle(WHOLE_SCENE, 1, 0).apply(firmer), 0)).toEqual([]);
});

test("what is so already, or names nobody, changes nothing", () => {
  const tied = tieToObstacle(WHOLE_SCENE, 1, 0).apply(scene);
  expect(tieToObstacle(WHOLE_SCENE, 1, 0).apply(tied)).toBe(tied);
  expect(untieFromObstacle(WHOLE_SCENE, 0, 0).apply(tied)).toBe(tied);
  expect(tieToObstacle(WHOLE_SCENE, 2, 0).apply(scene)).toBe(scene);
  expect(tieToObstacle(WHOLE_SCENE, 0, 1).apply(scene)).toBe(scene);
});
