import { beforeEach, describe, expect, test } from "vitest";
import { makeGroup } from "../document/commands/groups";
import { type Bench, createBench, SQUARE } from "./test-bench";

let bench: Bench;
beforeEach(() => {
  bench = createBench(SQUARE);
});

describe("selecting", () => {
  test("a click selects one agent, a click beside it nobody", () => {
    bench.click([4, 0]);
    expect(bench.selected()).toEqual([1]);
    bench.click([2, 2]);
    expect(bench.document.selection.value.kind).toBe("none");
  });

  test("Shift adds, Ctrl adds and takes away", () => {
    bench.click([0, 0]);
    bench.click([4, 0], { shift: true });
    bench.click([4, 4], { ctrl: true });
    expect(bench.selected()).toEqual([0, 1, 2]);
    bench.click([4, 0], { ctrl: true });
    bench.click([0, 0], { shift: true });
    expect(bench.selected()).toEqual([0, 2]);
  });

  test("a box selects who stands in it, while it is drawn", () => {
    bench.press([-1, -1]);
    bench.move([5, 1]);
    expect(bench.selected()).toEqual([0, 1]);
    expect(bench.toolbox.overlay.value).toEqual({ kind: "marquee", from: [-1, -1], to: [5, 1] });
    bench.move([1, 1]);
    bench.release([1, 1]);
    expect(bench.selected()).toEqual([0]);
    expect(bench.toolbox.overlay.value.kind).toBe("none");
  });

  test("a box adds with Shift and turns over with Ctrl", () => {
    bench.click([0, 0]);
    bench.drag(
      [
        [3, -1],
        [5, 5],
      ],
      { shift: true },
    );
    expect(bench.selected()).toEqual([0, 1, 2]);
    bench.drag(
      [
        [-1, -1],
        [5, 1],
      ],
      { ctrl: true },
    );
    expect(bench.selected()).toEqual([2]);
  });

  test("Escape takes a box back with all it selected", () => {
    bench.click([4, 4]);
    bench.press([-1, -1]);
    bench.move([5, 1]);
    expect(bench.toolbox.cancel()).toBe(true);
    expect(bench.selected()).toEqual([2]);
    expect(bench.toolbox.cancel()).toBe(false);
  });

  test("a click takes a group as one, a double click goes inside, Escape comes out again", () => {
    bench.document.perform(makeGroup(new Set([0, 1, 3])));
    bench.click([0, 0]);
    expect(bench.document.selection.value).toEqual({ kind: "group", path: [0] });
    bench.press([0, 0], { isDouble: true });
    bench.release([0, 0]);
    expect(bench.selected()).toEqual([0]);
    bench.click([4, 0]);
    expect(bench.selected()).toEqual([1]);
    expect(bench.toolbox.cancel()).toBe(true);
    expect(bench.document.selection.value).toEqual({ kind: "group", path: [0] });
    expect(bench.toolbox.cancel()).toBe(false);
  });

  test("groups that are hidden are not taken as one", () => {
    bench.document.perform(makeGroup(new Set([0, 1, 3])));
    bench.view.layers.value = { ...bench.view.layers.value, groups: false };
    bench.click([0, 0]);
    expect(bench.selected()).toEqual([0]);
    expect(bench.toolbox.cancel()).toBe(false);
  });

  test("Shift adds a whole group, Ctrl takes it away", () => {
    bench.document.perform(makeGroup(new Set([0, 1, 3])));
    bench.click([4, 4]);
    bench.click([0, 0], { shift: true });
    expect(bench.selected()).toEqual([0, 1, 2, 3]);
    bench.click([4, 0], { ctrl: true });
    expect(bench.selected()).toEqual([2]);
  });
});

describe("while the show moves", () => {
  beforeEach(() => {
    bench = createBench(SQUARE, SQUARE);
  });

  test("a press goes to the nearest keyframe, says so, and drags nobody along", () => {
    bench.playback.seek(3);
    const start = bench.document.scene.value;
    bench.drag([
      [0, 0],
      [2, 2],
    ]);
    expect(bench.playback.time.value).toBe(4);
    expect(bench.document.activeKeyframe.value).toBe(1);
    expect(bench.announced[0]).toContain("Keyframe 2");
    expect(bench.selected()).toEqual([0]);
    expect(bench.document.scene.value).toBe(start);
    bench.drag([
      [0, 0],
      [-2, -2.5],
    ]);
    expect(bench.place(0, 1)).toEqual([-2, -2.5]);
    expect(bench.place(0, 0)).toEqual([0, 0]);
  });

  test("a box begun beside everybody selects who stands in it at the keyframe, whoever came under the press", () => {
    bench = createBench(SQUARE, [
      [1, 1],
      [4, 0],
      [4, 4],
      [0, 4],
    ]);
    bench.playback.seek(3);
    const start = bench.document.scene.value;
    bench.shownXy = () => (bench.playback.time.value === 4 ? null : [9, 9, 4, 0, 4, 4, 0, 4]);
    bench.press([1, 1]);
    bench.move([3, 3]);
    expect(bench.toolbox.overlay.value).toEqual({ kind: "marquee", from: [1, 1], to: [3, 3] });
    bench.move([5, 5]);
    bench.release([5, 5]);
    expect(bench.playback.time.value).toBe(4);
    expect(bench.selected()).toEqual([0, 2]);
    expect(bench.document.scene.value).toBe(start);
  });

  test("a press stops the playing", () => {
    bench.playback.play();
    bench.click([0, 0]);
    expect(bench.playback.isPlaying.value).toBe(false);
  });
});
