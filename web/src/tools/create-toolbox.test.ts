import { expect, test } from "vitest";
import type { Point } from "../document/formation";
import { mainTrack } from "../document/scene";
import { type Bench, createLateBench } from "./test-bench";

const STROKE: readonly Point[] = [
  [0, 0],
  [4, 0],
  [8, 0],
];

const CORNERS: readonly Point[] = [
  [0, 0],
  [6, 0],
  [6, 6],
];

async function come(bench: Bench): Promise<void> {
  await bench.toolbox.wake();
  await bench.settled();
}

test("what was begun before the tools came is done with the tool that was in hand", async () => {
  const bench = createLateBench([]);
  bench.toolbox.active.value = "draw";
  bench.drag(STROKE);
  bench.toolbox.active.value = "select";
  await come(bench);
  expect(mainTrack(bench.document.scene.value).agents).toHaveLength(12);
  expect(bench.toolbox.active.value).toBe("select");
});

test("Enter closes a polygon whose corners were clicked before the tools came", async () => {
  const bench = createLateBench([]);
  bench.toolbox.active.value = "obstacle";
  for (const corner of CORNERS) bench.click(corner);
  bench.toolbox.placeInMiddle();
  await come(bench);
  expect(bench.document.scene.value.obstacles.map(({ shape }) => shape.kind)).toEqual(["polygon"]);
});

test("Escape gives up what was begun before the tools came", async () => {
  const bench = createLateBench([]);
  expect(bench.toolbox.cancel()).toBe(false);
  bench.toolbox.active.value = "draw";
  bench.press([0, 0]);
  bench.move([4, 0]);
  expect(bench.toolbox.cancel()).toBe(true);
  bench.release([8, 0]);
  await come(bench);
  expect(bench.document.undoLabel.value).toBeNull();
  expect(bench.toolbox.active.value).toBe("draw");
});

test("a pointer that passed by before the tools came begins nothing", async () => {
  const bench = createLateBench(STROKE);
  bench.move([0, 0]);
  expect(bench.toolbox.cancel()).toBe(false);
  await come(bench);
  expect(bench.toolbox.overlay.value.kind).toBe("none");
});
