import { beforeEach, describe, expect, test } from "vitest";
import { makeGroup } from "../document/commands/groups";
import { setHeight } from "../document/commands/heights";
import type { Point } from "../document/formation";
import { mainTrack } from "../document/scene";
import { type Bench, createBench } from "./test-bench";

const SQUARE: readonly Point[] = [
  [0, 0],
  [4, 0],
  [4, 4],
  [0, 4],
];

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

  test("a press stops the playing", () => {
    bench.playback.play();
    bench.click([0, 0]);
    expect(bench.playback.isPlaying.value).toBe(false);
  });
});
