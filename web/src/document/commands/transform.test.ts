import fc from "fast-check";
import { expect, test } from "vitest";
import { emptyScene } from "../defaults";
import type { Point } from "../formation";
import { mainTrack, type Scene } from "../scene";
import { addAgents } from "./agents";
import { alignAgents, distributeAgents, flipAgents, rotateAgents, scaleAgents } from "./transform";

const LINE: readonly Point[] = [
  [0, 0],
  [1, 3],
  [7, 1],
  [10, 4],
];
const ALL: ReadonlySet<number> = new Set([0, 1, 2, 3]);

const sceneOf = (places: readonly Point[]) => addAgents(places).apply(emptyScene());
const places = (scene: Scene) => mainTrack(scene).keyframes[0]?.positions.points() ?? [];

test("aligning brings agents onto an edge or the middle of their box and leaves the other coordinate", () => {
  const cases = [
    ["left", [0, 0, 0, 0], null],
    ["center", [5, 5, 5, 5], null],
    ["right", [10, 10, 10, 10], null],
    ["top", null, [4, 4, 4, 4]],
    ["middle", null, [2, 2, 2, 2]],
    ["bottom", null, [0, 0, 0, 0]],
  ] as const;
  for (const [edge, xs, ys] of cases) {
    const after = places(alignAgents(0, ALL, edge).apply(sceneOf(LINE)));
    expect(after.map(([x]) => x)).toEqual(xs ?? LINE.map(([x]) => x));
    expect(after.map(([, y]) => y)).toEqual(ys ?? LINE.map(([, y]) => y));
  }
});

test("distributing evens the gaps and leaves the outermost two", () => {
  const across = places(distributeAgents(0, ALL, "x").apply(sceneOf(LINE)));
  expect(across.map(([x]) => x)).toEqual([0, 3.33, 6.67, 10]);
  expect(across.map(([, y]) => y)).toEqual([0, 3, 1, 4]);
  const along = places(distributeAgents(0, ALL, "y").apply(sceneOf(LINE)));
  expect(along.map(([, y]) => y)).toEqual([0, 2.67, 1.33, 4]);
});

test("two agents have no gaps to even", () => {
  const scene = sceneOf(LINE);
  expect(distributeAgents(0, new Set([0, 1]), "x").apply(scene)).toBe(scene);
});

test("flipping twice is not flipping, to the last bit on the lattice", () => {
  const cm = fc.integer({ min: -5000, max: 5000 }).map((n) => n / 100);
  fc.assert(
    fc.property(fc.array(fc.tuple(cm, cm), { minLength: 1, maxLength: 8 }), (points) => {
      const scene = sceneOf(points);
      const agents = new Set(points.keys());
      for (const way of ["horizontal", "vertical"] as const) {
        const flip = flipAgents(0, agents, way);
        expect(places(flip.apply(flip.apply(scene)))).toEqual(places(scene));
      }
    }),
  );
});

test("four quarter turns bring everybody home", () => {
  const scene = sceneOf(LINE);
  const quarter = rotateAgents(0, ALL, [5, 2], Math.PI / 2);
  const turned = [1, 2, 3, 4].reduce((now) => quarter.apply(now), scene);
  expect(places(quarter.apply(scene))).toEqual([
    [7, -3],
    [4, -2],
    [6, 4],
    [3, 7],
  ]);
  expect(places(turned)).toEqual(LINE);
});

test("scaling leaves the anchor and agents that are not meant", () => {
  const scaled = places(scaleAgents(0, new Set([0, 3]), [0, 0], [2, 0.5]).apply(sceneOf(LINE)));
  expect(scaled).toEqual([
    [0, 0],
    [1, 3],
    [7, 1],
    [20, 2],
  ]);
});
