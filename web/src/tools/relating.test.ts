import { describe, expect, test } from "vitest";
import type { Point } from "../document/formation";
import { groupSet } from "../document/groups";
import { mainTrack } from "../document/scene";
import { type Bench, createBench } from "./test-bench";

const SIX: readonly Point[] = [
  [0, 0],
  [2, 0],
  [4, 0],
  [0, 3],
  [2, 3],
  [4, 3],
];

function benchWith(tool: "tie" | "group" | "pan"): Bench {
  const bench = createBench(SIX, SIX);
  bench.toolbox.active.value = tool;
  return bench;
}

const sets = (bench: Bench) => bench.document.scene.value.groups.map((group) => [...groupSet(group)].sort());

describe("ties", () => {
  test("pulling from agent to agent ties them and selects the tie", () => {
    const bench = benchWith("tie");
    bench.press([4, 3]);
    bench.move([1, 1]);
    expect(bench.toolbox.overlay.value).toEqual({ kind: "tie", from: 5, to: [1, 1], target: null });
    bench.move([0.1, 0]);
    expect(bench.toolbox.overlay.value).toMatchObject({ target: 0 });
    bench.release([0.1, 0]);
    expect(bench.document.scene.value.adjacency.ties).toEqual([[0, 5, 10]]);
    expect(bench.document.selection.value).toEqual({ kind: "tie", a: 0, b: 5 });
    expect(bench.toolbox.overlay.value.kind).toBe("none");
  });

  test("a tie can hold at one keyframe only", () => {
    const bench = benchWith("tie");
    bench.playback.seek(4);
    bench.toolbox.tieScope.value = "keyframe";
    bench.drag([
      [0, 0],
      [2, 0],
    ]);
    expect(bench.document.scene.value.adjacency.ties).toEqual([]);
    expect(mainTrack(bench.document.scene.value).keyframes[1]?.adjacency?.ties).toEqual([[0, 1, 10]]);
  });

  test("pulled to nobody, or given up, nothing is tied", () => {
    const bench = benchWith("tie");
    bench.drag([
      [0, 0],
      [1, 1],
    ]);
    bench.drag([
      [0, 0],
      [1, 1],
      [0, 0],
    ]);
    bench.press([0, 0]);
    bench.move([2, 0]);
    bench.toolbox.cancel();
    bench.release([2, 0]);
    expect(bench.document.undoLabel.value).toBeNull();
  });

  test("a click on a tie selects it, beside it nothing", () => {
    const bench = benchWith("tie");
    bench.ties.value = [{ pairs: Uint32Array.of(0, 1, 1, 4) }];
    bench.click([2, 1.5]);
    expect(bench.document.selection.value).toEqual({ kind: "tie", a: 1, b: 4 });
    bench.click([1, 1.5]);
    expect(bench.document.selection.value.kind).toBe("none");
  });
});

describe("groups", () => {
  test("a box makes a group of who stands in it", () => {
    const bench = benchWith("group");
    bench.drag([
      [-1, -1],
      [3, 1],
    ]);
    expect(sets(bench)).toEqual([[0, 1]]);
    expect(bench.document.selection.value).toEqual({ kind: "group", path: [0] });
    expect(bench.document.undoLabel.value).toBe("Make group");
  });

  test("a box begun between keyframes makes its group at the nearest", () => {
    const bench = benchWith("group");
    bench.playback.seek(3);
    bench.drag([
      [-1, -1],
      [2, 2],
      [3, 1],
    ]);
    expect(bench.playback.time.value).toBe(4);
    expect(sets(bench)).toEqual([[0, 1]]);
  });

  test("the same box again selects the group it made", () => {
    const bench = benchWith("group");
    bench.drag([
      [-1, -1],
      [3, 1],
    ]);
    bench.click([10, 10]);
    bench.drag([
      [-1, -1],
      [3, 1],
    ]);
    expect(sets(bench)).toEqual([[0, 1]]);
    expect(bench.document.selection.value).toEqual({ kind: "group", path: [0] });
  });

  test("Shift adds to the selected group, by box and by click, and Ctrl takes out", () => {
    const bench = benchWith("group");
    bench.drag([
      [-1, -1],
      [3, 1],
    ]);
    bench.drag(
      [
        [3, -1],
        [5, 1],
      ],
      { shift: true },
    );
    bench.click([4, 3], { shift: true });
    expect(sets(bench)).toEqual([[0, 1, 2, 5]]);
    bench.click([0, 0], { ctrl: true });
    expect(sets(bench)).toEqual([[1, 2, 5]]);
  });

  test("a click selects the group of an agent, or the agent when it has none", () => {
    const bench = benchWith("group");
    bench.drag([
      [-1, -1],
      [3, 1],
    ]);
    bench.click([10, 10]);
    bench.click([2, 0]);
    expect(bench.document.selection.value).toEqual({ kind: "group", path: [0] });
    bench.click([4, 3]);
    expect(bench.selected()).toEqual([5]);
  });
});

test("the hand moves the view and nothing else", () => {
  const bench = benchWith("pan");
  const { left, top } = bench.view.camera.value;
  const scene = bench.document.scene.value;
  bench.drag([
    [0, 0],
    [1, 0],
  ]);
  expect(bench.view.camera.value.left).toBeCloseTo(left + 40, 6);
  expect(bench.view.camera.value.top).toBeCloseTo(top, 6);
  expect(bench.document.scene.value).toBe(scene);
});
