import { beforeEach, describe, expect, test } from "vitest";
import type { Point } from "../document/formation";
import { type Bench, createBench, SQUARE } from "./test-bench";

let bench: Bench;
beforeEach(() => {
  bench = createBench(SQUARE);
});

describe("the box around several", () => {
  /** Pixels from the middles of agents to the box: their radius and 12. */
  const MARGIN = (11 + 12) / 40;

  beforeEach(() =>
    bench.drag([
      [-1, -1],
      [5, 5],
    ]),
  );

  test("the handle above turns them about their middle", () => {
    const above: Point = [2, 4 + MARGIN + 22 / 40];
    bench.drag([above, [5, 2], [20, 2]]);
    expect(bench.place(0)).toEqual([0, 4]);
    expect(bench.place(1)).toEqual([0, 0]);
    expect(bench.document.undoLabel.value).toBe("Rotate agents");
  });

  test("Shift turns in steps of 15°", () => {
    const above: Point = [2, 4 + MARGIN + 22 / 40];
    bench.drag([above, [5, 2.3], [20, 2.3]], { shift: true });
    expect(bench.place(0)).toEqual([0, 4]);
  });

  test("a corner scales from the opposite one, Alt from the middle, Shift alike both ways", () => {
    const corner: Point = [4 + MARGIN, 4 + MARGIN];
    bench.drag([corner, [corner[0] + 4, corner[1] + 2]]);
    expect([bench.place(0), bench.place(2)]).toEqual([
      [0, 0],
      [8, 6],
    ]);
    bench.document.undo();
    bench.drag([corner, [corner[0] + 1, corner[1] + 1]], { alt: true });
    expect([bench.place(0), bench.place(2)]).toEqual([
      [-1, -1],
      [5, 5],
    ]);
    bench.document.undo();
    bench.drag([corner, [corner[0] + 4, corner[1] + 1]], { shift: true });
    expect([bench.place(0), bench.place(2)]).toEqual([
      [0, 0],
      [8, 8],
    ]);
  });

  test("an edge scales one way only", () => {
    bench.drag([
      [4 + MARGIN, 2],
      [6 + MARGIN, 3],
    ]);
    expect([bench.place(0), bench.place(2)]).toEqual([
      [0, 0],
      [6, 4],
    ]);
  });

  test("a box pushed flat keeps its agents apart", () => {
    bench.drag([
      [4 + MARGIN, 2],
      [MARGIN, 2],
    ]);
    expect(bench.place(1)[0]).not.toBe(bench.place(0)[0]);
  });

  test("turning is given up by Escape", () => {
    const start = bench.document.scene.value;
    bench.press([2, 4 + MARGIN + 22 / 40]);
    bench.move([9, 2]);
    expect(bench.document.scene.value).not.toBe(start);
    bench.toolbox.cancel();
    expect(bench.document.scene.value).toBe(start);
  });
});
