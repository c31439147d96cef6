import { beforeEach, describe, expect, test } from "vitest";
import { setHeight } from "../document/commands/heights";
import type { Point } from "../document/formation";
import { mainTrack } from "../document/scene";
import { type Bench, createBench, SQUARE } from "./test-bench";

let bench: Bench;
beforeEach(() => {
  bench = createBench(SQUARE);
});

describe("the handle that lifts", () => {
  /** Beside the middle of the box's right edge. */
  const HANDLE: Point = [4 + (11 + 12) / 40 + 22 / 40, 2];
  const up = (by: number): Point => [HANDLE[0] + 0.3, HANDLE[1] + by];
  const heights = () =>
    Array.from({ length: 4 }, (_, agent) =>
      mainTrack(bench.document.scene.value).keyframes[0]?.positions.height(agent),
    );

  beforeEach(() =>
    bench.drag([
      [-1, -1],
      [5, 5],
    ]),
  );

  test("says the height, lifts by whole centimeters as far as it is pulled, and is one undo entry", () => {
    const start = bench.document.scene.value;
    bench.move(HANDLE);
    expect(bench.toolbox.overlay.value).toEqual({ kind: "lift", by: 0, words: "z 0.00 m" });
    bench.press(HANDLE);
    bench.move(up(1));
    bench.move(up(2.3456));
    expect(bench.toolbox.overlay.value).toEqual({ kind: "lift", by: 2.35, words: "z 2.35 m" });
    bench.release(up(2.3456));
    expect(heights()).toEqual([2.35, 2.35, 2.35, 2.35]);
    expect([bench.place(0), bench.place(2)]).toEqual([
      [0, 0],
      [4, 4],
    ]);
    bench.document.undo();
    expect(bench.document.scene.value).toBe(start);
    expect(bench.document.undoLabel.value).toBeNull();
  });

  test("Escape leaves the identical scene", () => {
    const start = bench.document.scene.value;
    bench.press(HANDLE);
    bench.move(up(3));
    expect(bench.document.scene.value).not.toBe(start);
    bench.toolbox.cancel();
    expect(bench.document.scene.value).toBe(start);
  });

  test("is held at the ground and at others' heights, unless Alt is held; Shift goes by whole meters", () => {
    bench.document.perform(setHeight(0, 0, 1.5));
    bench.drag([
      [3, -1],
      [5, 5],
    ]);
    bench.press(HANDLE);
    bench.move(up(1.47));
    expect(heights()).toEqual([1.5, 1.5, 1.5, 0]);
    bench.move(up(1.47), { alt: true });
    expect(heights()).toEqual([1.5, 1.47, 1.47, 0]);
    bench.move(up(2.7), { shift: true });
    expect(heights()).toEqual([1.5, 3, 3, 0]);
    bench.move(up(0.04));
    bench.release(up(0.04));
    expect(heights()).toEqual([1.5, 0, 0, 0]);
  });
});
