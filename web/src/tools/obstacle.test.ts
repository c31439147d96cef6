import { beforeEach, expect, test } from "vitest";
import type { Point } from "../document/formation";
import { type Bench, createBench } from "./test-bench";

/** On the bench a meter is forty pixels. */
let bench: Bench;

beforeEach(() => {
  bench = createBench([[-9, -9]]);
  bench.toolbox.active.value = "obstacle";
});

const shapes = () => bench.document.scene.value.obstacles.map(({ shape }) => shape);
const clicks = (...places: readonly Point[]) => {
  for (const at of places) bench.click(at);
};

test("a drag makes a circle about where it began, as one undo entry", () => {
  bench.drag([
    [1, 1],
    [2, 1],
    [3, 1],
  ]);
  expect(shapes()).toEqual([{ kind: "circle", center: [1, 1], radius: 2 }]);
  expect(bench.document.selection.value).toEqual({ kind: "obstacle", index: 0 });
  bench.document.undo();
  expect(shapes()).toEqual([]);
});

test.each([
  ["a click on its first corner", () => bench.click([0.1, 0])],
  ["Enter", () => bench.toolbox.placeInMiddle()],
])("clicks make a polygon, closed by %s", (_, close) => {
  clicks([0, 0], [4, 0], [4, 3]);
  bench.move([1, 3]);
  expect(shapes()).toEqual([]);
  expect(bench.toolbox.overlay.value).toMatchObject({ kind: "outline", next: [1, 3] });
  close();
  expect(shapes()).toEqual([
    {
      kind: "polygon",
      points: [
        [0, 0],
        [4, 0],
        [4, 3],
      ],
    },
  ]);
  expect(bench.toolbox.overlay.value).toEqual({ kind: "none" });
});

test("two corners are no obstacle: it is said, and the polygon stays open", () => {
  clicks([0, 0], [4, 0]);
  bench.toolbox.placeInMiddle();
  expect(bench.warned).toEqual(["That is no obstacle yet."]);
  clicks([4, 3]);
  bench.toolbox.placeInMiddle();
  expect(shapes()).toHaveLength(1);
});

test("sides that cross are no obstacle: it is said what helps, and the polygon stays open", () => {
  clicks([0, 0], [4, 4], [4, 0], [0, 3]);
  bench.toolbox.placeInMiddle();
  expect(shapes()).toEqual([]);
  expect(bench.warned).toEqual(["That is no obstacle yet."]);
  expect(bench.toolbox.overlay.value).toMatchObject({ kind: "outline" });
});

test("Escape gives up the polygon under way and nothing else", () => {
  clicks([0, 0], [4, 0]);
  expect(bench.toolbox.cancel()).toBe(true);
  expect(bench.toolbox.overlay.value).toEqual({ kind: "none" });
  expect(bench.toolbox.cancel()).toBe(false);
});

test("Enter without a polygon under way places a circle in the middle", () => {
  bench.toolbox.placeInMiddle();
  expect(shapes()).toMatchObject([{ kind: "circle", radius: 2 }]);
});

test("an obstacle that is there is moved and not drawn over, and cancel puts it back", () => {
  bench.drag([
    [1, 1],
    [3, 1],
  ]);
  const before = bench.document.scene.value;
  bench.drag([
    [1.5, 1],
    [3, 2],
    [4.5, 3],
  ]);
  expect(shapes()).toEqual([{ kind: "circle", center: [4, 3], radius: 2 }]);
  bench.document.undo();
  expect(bench.document.scene.value).toBe(before);
  bench.press([1.5, 1]);
  bench.move([5, 5]);
  bench.toolbox.cancel();
  expect(bench.document.scene.value).toBe(before);
});

test("obstacles hold throughout the show: making one goes to no keyframe", () => {
  bench = createBench([[-9, -9]], [[-8, -8]]);
  bench.toolbox.active.value = "obstacle";
  bench.playback.seek(1.5);
  bench.drag([
    [1, 1],
    [3, 1],
  ]);
  expect(bench.playback.time.value).toBe(1.5);
  expect(shapes()).toHaveLength(1);
});

test("an agent is tied to an obstacle by pulling from one to the other, and to no other agent", () => {
  bench.drag([
    [1, 1],
    [3, 1],
  ]);
  bench.toolbox.active.value = "tie";
  bench.drag([
    [-9, -9],
    [-3, -3],
    [1, 1],
  ]);
  expect(bench.document.scene.value.adjacency.obstacleTies).toEqual([[0, 0, 1]]);
  expect(bench.document.selection.value).toEqual({ kind: "obstacle", index: 0 });
  expect(bench.announced.at(-1)).toBe("1 tied to Obstacle 1");
});

test("with Select in hand a click on an obstacle picks it, and a marquee begun on it picks agents", () => {
  bench.drag([
    [1, 1],
    [3, 1],
  ]);
  bench.toolbox.active.value = "select";
  bench.click([8, 8]);
  expect(bench.document.selection.value.kind).toBe("none");
  bench.click([1.5, 1]);
  expect(bench.document.selection.value).toEqual({ kind: "obstacle", index: 0 });
  bench.drag([
    [1.5, 1],
    [-5, -5],
    [-10, -10],
  ]);
  expect(bench.selected()).toEqual([0]);
});
