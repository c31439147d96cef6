import { describe, expect, test } from "vitest";
import type { Point } from "../document/formation";
import { mainTrack } from "../document/scene";
import { createBench } from "./test-bench";

const FOUR: readonly Point[] = [
  [0, 0],
  [2, 0],
  [4, 0],
  [6, 0],
];

const LINE: readonly Point[] = [
  [0, 5],
  [1.5, 5],
  [3, 5],
];

const LOOP = Array.from(
  { length: 41 },
  (_, i): Point => [4 * Math.cos((2 * Math.PI * i) / 40), 4 * Math.sin((2 * Math.PI * i) / 40)],
);

describe("drawing", () => {
  test("a stroke brings as many agents as set, evenly, both ends occupied, as one undo entry", () => {
    const bench = createBench();
    const start = bench.document.scene.value;
    bench.toolbox.active.value = "draw";
    bench.toolbox.spacing.value = { by: "count", count: 4 };
    bench.drag(LINE);
    expect([0, 1, 2, 3].map((agent) => bench.place(agent))).toEqual([
      [0, 5],
      [1, 5],
      [2, 5],
      [3, 5],
    ]);
    bench.document.undo();
    expect(bench.document.scene.value).toBe(start);
  });

  test("places show along the stroke before it is finished, and nothing is made when it is given up", () => {
    const bench = createBench();
    bench.toolbox.active.value = "draw";
    bench.press([0, 0]);
    bench.move([3, 0]);
    const overlay = bench.toolbox.overlay.value;
    expect(overlay.kind === "stroke" && overlay.places.length).toBe(12);
    bench.toolbox.cancel();
    bench.release([3, 0]);
    expect(mainTrack(bench.document.scene.value).agents).toHaveLength(0);
    expect(bench.toolbox.overlay.value.kind).toBe("none");
  });

  test("a closed stroke is filled, with Alt only lined", () => {
    for (const alt of [false, true]) {
      const bench = createBench();
      bench.toolbox.active.value = "draw";
      bench.toolbox.spacing.value = { by: "count", count: 30 };
      bench.drag(LOOP, { alt });
      const reaches = Array.from({ length: 30 }, (_, agent) => Math.hypot(...bench.place(agent)));
      const inside = reaches.filter((reach) => reach < 3).length;
      if (alt) expect(inside).toBe(0);
      else expect(inside).toBeGreaterThan(9);
    }
  });

  test("a click adds one agent", () => {
    const bench = createBench();
    bench.toolbox.active.value = "draw";
    bench.click([1.234, 5.678]);
    expect(bench.place(0)).toEqual([1.23, 5.68]);
  });

  test("by interval the length of the stroke says how many", () => {
    const bench = createBench();
    bench.toolbox.active.value = "draw";
    bench.toolbox.spacing.value = { by: "interval", meters: 0.5 };
    bench.drag(LINE);
    expect(mainTrack(bench.document.scene.value).agents).toHaveLength(7);
  });

  test("a second formation takes the show's agents to the nearest places, as one undo entry", async () => {
    const bench = createBench(FOUR, FOUR);
    bench.playback.seek(4);
    const start = bench.document.scene.value;
    const asked: Point[][] = [];
    bench.assign = async (source, target) => {
      asked.push(source.points(), target.points());
      return [3, 2, 1, 0];
    };
    bench.toolbox.active.value = "draw";
    bench.drag(LINE);
    expect([0, 1, 2, 3].map((agent) => bench.place(agent, 1))).toEqual([
      [0, 5],
      [1, 5],
      [2, 5],
      [3, 5],
    ]);
    await bench.settled();
    expect([0, 1, 2, 3].map((agent) => bench.place(agent, 1))).toEqual([
      [3, 5],
      [2, 5],
      [1, 5],
      [0, 5],
    ]);
    expect(asked).toEqual([
      FOUR,
      [
        [0, 5],
        [1, 5],
        [2, 5],
        [3, 5],
      ],
    ]);
    expect(bench.announced.join()).toContain("Every keyframe has the same 4 agents");
    bench.document.undo();
    expect(bench.document.scene.value).toBe(start);
    expect(bench.document.undoLabel.value).toBeNull();
  });

  test("only the selected agents are placed when some are", async () => {
    const bench = createBench(FOUR, FOUR);
    bench.playback.seek(4);
    bench.document.selection.value = { kind: "agents", agents: new Set([1, 3]) };
    bench.toolbox.active.value = "draw";
    bench.drag(LINE);
    await bench.settled();
    expect([0, 1, 2, 3].map((agent) => bench.place(agent, 1))).toEqual([
      [0, 0],
      [0, 5],
      [4, 0],
      [3, 5],
    ]);
  });

  test("when the engine does not answer they stand as drawn, and it is said", async () => {
    const bench = createBench(FOUR, FOUR);
    bench.playback.seek(4);
    bench.assign = () => Promise.reject(new Error("gone"));
    bench.toolbox.active.value = "draw";
    bench.drag(LINE);
    await bench.settled();
    expect(bench.place(3, 1)).toEqual([3, 5]);
    expect(bench.warned).toHaveLength(1);
    expect(bench.document.isDragging.value).toBe(false);
  });

  test("undo before the engine answers takes the stroke back, and the late answer changes nothing", async () => {
    const bench = createBench(FOUR, FOUR);
    bench.playback.seek(4);
    const start = bench.document.scene.value;
    bench.toolbox.active.value = "draw";
    bench.drag(LINE);
    bench.document.undo();
    await bench.settled();
    expect(bench.document.scene.value).toBe(start);
  });

  test("a stroke while agents move goes to the nearest keyframe and is drawn there", async () => {
    const bench = createBench(FOUR, FOUR);
    bench.playback.seek(2.5);
    bench.toolbox.active.value = "draw";
    bench.drag(LINE);
    await bench.settled();
    expect(bench.place(0, 1)).toEqual([0, 5]);
    expect(bench.place(0, 0)).toEqual([0, 0]);
  });

  test("more agents than a show can have are refused with what there is room for", () => {
    const bench = createBench(FOUR);
    bench.toolbox.active.value = "draw";
    bench.toolbox.spacing.value = { by: "count", count: 5000 };
    bench.drag(LINE);
    expect(bench.warned).toEqual(["5,000 agents are too many."]);
    expect(bench.document.undoLabel.value).toBeNull();
  });
});

describe("shapes", () => {
  test("a drag places the shape in hand", () => {
    const bench = createBench();
    bench.toolbox.active.value = "shape";
    bench.toolbox.shape.value = "grid";
    bench.toolbox.spacing.value = { by: "count", count: 6 };
    bench.press([0, 0]);
    bench.move([4, 2]);
    expect(bench.toolbox.overlay.value.kind).toBe("shape");
    bench.release([4, 2]);
    const places = Array.from({ length: 6 }, (_, agent) => bench.place(agent));
    expect(places).toEqual([
      [0, 0],
      [2, 0],
      [4, 0],
      [0, 2],
      [2, 2],
      [4, 2],
    ]);
  });

  test("Alt draws from the middle, Shift as deep as wide, a line by half right angles", () => {
    const bench = createBench();
    bench.toolbox.active.value = "shape";
    bench.toolbox.shape.value = "line";
    bench.toolbox.spacing.value = { by: "count", count: 2 };
    bench.drag(
      [
        [1, 1],
        [3, 1.4],
      ],
      { alt: true, shift: true },
    );
    expect([bench.place(0), bench.place(1)]).toEqual([
      [-1, 1],
      [3, 1],
    ]);
  });

  test("without a pointer the shape in hand goes into the middle of what is seen", async () => {
    const bench = createBench();
    bench.view.size.value = { width: 1000, height: 800 };
    bench.view.camera.value = { scale: 40, left: 500, top: 400 };
    bench.toolbox.placeInMiddle();
    expect(bench.document.undoLabel.value).toBeNull();
    bench.toolbox.active.value = "shape";
    bench.toolbox.shape.value = "grid";
    bench.toolbox.spacing.value = { by: "count", count: 4 };
    bench.toolbox.placeInMiddle();
    await bench.settled();
    const places = [0, 1, 2, 3].map((agent) => bench.place(agent));
    expect(places).toEqual([
      [-5, -4],
      [5, -4],
      [-5, 4],
      [5, 4],
    ]);
  });

  test("a click places nothing and says what to do", () => {
    const bench = createBench();
    bench.toolbox.active.value = "shape";
    bench.click([1, 1]);
    expect(bench.document.undoLabel.value).toBeNull();
    expect(bench.announced).toEqual(["Drag to give the shape its size"]);
  });

  test("at a later keyframe a shape has exactly as many places as there are agents", async () => {
    const bench = createBench(FOUR, FOUR);
    bench.playback.seek(4);
    bench.toolbox.active.value = "shape";
    bench.toolbox.shape.value = "line";
    bench.toolbox.spacing.value = { by: "count", count: 99 };
    bench.drag([
      [0, 5],
      [3, 5],
    ]);
    await bench.settled();
    expect(mainTrack(bench.document.scene.value).agents).toHaveLength(4);
    expect(bench.place(2, 1)).toEqual([2, 5]);
  });
});
