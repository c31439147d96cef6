import { expect, test } from "vitest";
import { emptyScene } from "../defaults";
import type { Point } from "../formation";
import type { ObstacleShape, Scene } from "../scene";
import { addObstacle, deleteObstacle, renameObstacle, setObstacleShape } from "./obstacles";

const DISC: ObstacleShape = { kind: "circle", center: [1, 2], radius: 1.5 };
const POST: ObstacleShape = { kind: "circle", center: [9, 2], radius: 0.2 };
const TRIANGLE: ObstacleShape = {
  kind: "polygon",
  points: [
    [0, 0],
    [2, 0],
    [1, 2],
  ],
};

const empty = emptyScene();
const two = [DISC, TRIANGLE].reduce<Scene>((scene, shape) => addObstacle(shape).apply(scene), empty);

test("obstacles are added, changed and named", () => {
  expect(two.obstacles.map(({ shape }) => shape)).toEqual([DISC, TRIANGLE]);
  expect(setObstacleShape(0, POST).apply(two).obstacles[0]?.shape).toEqual(POST);
  expect(renameObstacle(1, "  Tree ").apply(two).obstacles[1]?.name).toBe("Tree");
});

test.each<readonly [string, ObstacleShape]>([
  ["a circle without extent", { ...DISC, radius: 0 }],
  ["a circle out of the world", { ...DISC, center: [1e6, 0] }],
  ["a circle without a number", { ...DISC, radius: Number.NaN }],
  ["two corners", { kind: "polygon", points: TRIANGLE.kind === "polygon" ? TRIANGLE.points.slice(1) : [] }],
  [
    "corners in a line",
    {
      kind: "polygon",
      points: [
        [0, 0],
        [1, 1],
        [2, 2],
      ],
    },
  ],
  [
    "a bow",
    {
      kind: "polygon",
      points: [
        [0, 0],
        [4, 4],
        [4, 0],
        [0, 3],
      ],
    },
  ],
  ["more corners than a scene may hold", { kind: "polygon", points: Array.from({ length: 201 }, corner) }],
])("%s is no obstacle", (_, shape) => {
  expect(addObstacle(shape).apply(two)).toBe(two);
  expect(setObstacleShape(0, shape).apply(two)).toBe(two);
});

test("a scene has two hundred obstacles at most", () => {
  let scene = empty;
  for (let index = 0; index < 201; index += 1) scene = addObstacle(DISC).apply(scene);
  expect(scene.obstacles).toHaveLength(200);
});

test("ties to a deleted obstacle go with it, those to later ones follow", () => {
  const three = addObstacle(POST).apply(two);
  const tied: Scene = {
    ...three,
    adjacency: {
      ...three.adjacency,
      obstacleTies: [
        [0, 0, 1],
        [1, 1, 2],
        [2, 2, 3],
      ],
    },
  };
  const after = deleteObstacle(1).apply(tied);
  expect(after.obstacles.map(({ shape }) => shape)).toEqual([DISC, POST]);
  expect(after.adjacency.obstacleTies).toEqual([
    [0, 0, 1],
    [2, 1, 3],
  ]);
});

function corner(_: unknown, index: number): Point {
  return [Math.cos(index / 40), Math.sin(index / 40)];
}
