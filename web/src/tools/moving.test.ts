import { beforeEach, describe, expect, test } from "vitest";
import { makeGroup } from "../document/commands/groups";
import { type Bench, createBench, SQUARE } from "./test-bench";

let bench: Bench;
beforeEach(() => {
  bench = createBench(SQUARE);
});

describe("moving", () => {
  test("a drag moves an agent, by whole centimeters, as one undo entry", () => {
    const start = bench.document.scene.value;
    bench.drag([
      [0, 0],
      [0.3, 0.2],
      [1.2345, 0.7],
      [-1.2345, -2.001],
    ]);
    expect(bench.place(0)).toEqual([-1.23, -2]);
    expect(bench.document.undoLabel.value).toBe("Move agents");
    bench.document.undo();
    expect(bench.document.scene.value).toBe(start);
    expect(bench.document.undoLabel.value).toBeNull();
  });

  test("a hand that trembles on a click moves nobody", () => {
    bench.drag([
      [0, 0],
      [0.05, 0.05],
    ]);
    expect(bench.document.undoLabel.value).toBeNull();
    expect(bench.selected()).toEqual([0]);
  });

  test("pulling one of several selected moves them all, clicking it selects it alone", () => {
    bench.drag([
      [-1, -1],
      [5, 1],
    ]);
    bench.drag([
      [0, 0],
      [0, -3],
    ]);
    expect([bench.place(0), bench.place(1), bench.place(2)]).toEqual([
      [0, -3],
      [4, -3],
      [4, 4],
    ]);
    expect(bench.selected()).toEqual([0, 1]);
    bench.click([4, -3]);
    expect(bench.selected()).toEqual([1]);
  });

  test("pulling an agent of a group moves them all as one, and from inside the agent alone", () => {
    bench.document.perform(makeGroup(new Set([0, 1])));
    bench.drag([
      [0, 0],
      [0, -3],
    ]);
    expect([bench.place(0), bench.place(1), bench.place(2)]).toEqual([
      [0, -3],
      [4, -3],
      [4, 4],
    ]);
    bench.press([0, -3], { isDouble: true });
    bench.move([0, -5]);
    bench.release([0, -5]);
    expect([bench.place(0), bench.place(1)]).toEqual([
      [0, -5],
      [4, -3],
    ]);
  });

  test("pulling one that is not selected leaves the selected ones", () => {
    bench.click([0, 0]);
    bench.drag([
      [4, 4],
      [4, 7],
    ]);
    expect(bench.selected()).toEqual([2]);
    expect(bench.place(0)).toEqual([0, 0]);
  });

  test("Shift keeps a move to one axis", () => {
    bench.click([0, 0]);
    bench.drag(
      [
        [0, 0],
        [3.2, 1.1],
      ],
      { shift: true },
    );
    expect(bench.place(0)).toEqual([3.2, 0]);
  });

  test("Escape leaves the identical scene, and the rest of the drag does nothing", () => {
    const start = bench.document.scene.value;
    bench.press([0, 0]);
    bench.move([2, 1]);
    expect(bench.document.isDragging.value).toBe(true);
    bench.toolbox.cancel();
    expect(bench.document.scene.value).toBe(start);
    bench.move([3, 1]);
    bench.release([3, 1]);
    expect(bench.document.scene.value).toBe(start);
    expect(bench.document.isDragging.value).toBe(false);
  });

  test("another tool taken up in the middle of a drag gives it up", () => {
    const start = bench.document.scene.value;
    bench.press([0, 0]);
    bench.move([2, 1]);
    bench.toolbox.active.value = "tie";
    expect(bench.document.scene.value).toBe(start);
    expect(bench.document.isDragging.value).toBe(false);
  });

  test("an agent is drawn into line with a neighbor, unless Alt is held", () => {
    bench.press([0, 0]);
    bench.move([2, 1]);
    bench.move([1.2, 3.93]);
    expect(bench.place(0)).toEqual([1.2, 4]);
    expect(bench.toolbox.overlay.value).toMatchObject({ kind: "guides" });
    bench.move([1.2, 3.93], { alt: true });
    expect(bench.place(0)).toEqual([1.2, 3.93]);
    bench.release([1.2, 3.93], { alt: true });
    expect(bench.toolbox.overlay.value.kind).toBe("none");
  });
});

describe("from the front", () => {
  test("a move says how high it lifts, and feet find the ground", () => {
    bench.view.projection.value = "front";
    bench.press([4, 4]);
    bench.move([6.3, 1.5]);
    expect(bench.toolbox.overlay.value).toMatchObject({ kind: "guides", height: { words: "z 1.50 m" } });
    bench.move([6.3, 0.07]);
    expect(bench.place(2)[1]).toBe(0);
    bench.release([6.3, 0.07]);
    expect(bench.toolbox.overlay.value.kind).toBe("none");
  });
});
