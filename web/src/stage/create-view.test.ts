import { signal } from "@preact/signals";
import { describe, expect, it } from "vitest";
import { Formation, type Point } from "../document/formation";
import type { Scene } from "../document/scene";
import { toScreen, toStage } from "./camera";
import { createView } from "./create-view";

const SIZE = { width: 1137, height: 689 };

function sceneOf(places: readonly Point[]): Scene {
  return {
    title: "",
    seed: 0,
    stage: { width: 100, depth: 60, height: 0, backdrop: "grid", units: "m" },
    tempo: { beatsPerMinute: 120, beatsPerBar: 4, start: 0 },
    frameRate: 30,
    minimumDistance: 0,
    join: "separate",
    tension: 0.5,
    groups: [],
    adjacency: { base: "delaunay", weights: "inverse", ties: [], cuts: [], obstacleTies: [] },
    tracks: [
      {
        agents: [],
        keyframes: [
          {
            name: "",
            time: 0,
            hold: 0,
            corner: false,
            between: 0,
            positions: Formation.from(places),
            absent: [],
            adjacency: null,
          },
        ],
        segments: [],
      },
    ],
    obstacles: [],
  };
}

function viewOf(places: readonly Point[]) {
  const view = createView(signal(sceneOf(places)));
  view.size.value = SIZE;
  return view;
}

describe("view", () => {
  it("an empty scene shows the whole stage, and that is 100 %", () => {
    const view = viewOf([]);
    expect(view.zoom.value).toBeCloseTo(1, 12);
    const corner = toScreen(view.camera.value, [-50, 30]);
    expect(corner.x).toBeGreaterThanOrEqual(0);
    expect(corner.y).toBeGreaterThanOrEqual(0);
  });

  it("the numbers beside a stage as wide as the window stand clear of the tools", () => {
    const view = viewOf([]);
    view.size.value = { width: 760, height: 689 };
    // Numbers end 8 pixels before the sheet and take some 20; the tools end 56 or, on a touch screen, 64 pixels from the left.
    expect(toScreen(view.camera.value, [-50, 30]).x - 8 - 20).toBeGreaterThanOrEqual(64);
  });

  it("a show that nearly fills the stage leaves the stage whole", () => {
    expect(
      viewOf([
        [-44, -25],
        [44, 25],
      ]).zoom.value,
    ).toBeCloseTo(1, 12);
  });

  it("a small show is brought closer, all of it in sight", () => {
    const places: Point[] = [
      [10, 0],
      [20, 0],
      [20, 10],
      [12, 4],
    ];
    const view = viewOf(places);
    expect(view.zoom.value).toBeGreaterThan(1.25);
    for (const place of places) {
      const at = toScreen(view.camera.value, place);
      expect(at.x).toBeGreaterThan(0);
      expect(at.x).toBeLessThan(SIZE.width);
      expect(at.y).toBeGreaterThan(0);
      expect(at.y).toBeLessThan(SIZE.height);
    }
  });

  it("a show beyond the stage is fitted, too", () => {
    const view = viewOf([
      [-300, 0],
      [300, 0],
    ]);
    expect(toScreen(view.camera.value, [300, 0]).x).toBeLessThan(SIZE.width);
    expect(toScreen(view.camera.value, [-300, 0]).x).toBeGreaterThan(0);
  });

  it("a lone agent does not fill the screen", () => {
    expect(viewOf([[3, 3]]).zoom.value).toBeCloseTo(6, 9);
  });

  it("resizing fits again until the person has moved the stage, then keeps the middle", () => {
    const view = viewOf([]);
    view.size.value = { width: 800, height: 500 };
    expect(view.zoom.value).toBeCloseTo(1, 12);
    view.panBy(30, 10);
    view.zoomBy(2);
    const middle = toStage(view.camera.value, { x: 400, y: 250 });
    view.size.value = { width: 600, height: 700 };
    const after = toScreen(view.camera.value, middle);
    expect(after.x).toBeCloseTo(300, 9);
    expect(after.y).toBeCloseTo(350, 9);
    view.fit();
    expect(view.zoom.value).toBeCloseTo(1, 12);
  });

  it("what is fitted makes way for a sheet from below, and comes back when it goes", () => {
    const places: Point[] = [
      [-40, -25],
      [40, 25],
    ];
    const view = viewOf(places);
    view.size.value = { width: 390, height: 600 };
    const before = view.camera.value;
    view.covered.value = 320;
    for (const place of places) {
      const { y } = toScreen(view.camera.value, place);
      expect(y).toBeGreaterThan(0);
      expect(y).toBeLessThan(600 - 320);
    }
    view.covered.value = 0;
    expect(view.camera.value).toEqual(before);
  });

  it("where the person has zoomed or panned to stays where it is, whatever lies over it", () => {
    const view = viewOf([]);
    view.zoomBy(2);
    const own = view.camera.value;
    view.covered.value = 300;
    expect(view.camera.value).toBe(own);
    view.fit();
    expect(toScreen(view.camera.value, [0, -30]).y).toBeLessThan(SIZE.height - 300);
  });

  it("what is shown instead of the show stays fitted until the whole show is asked for", () => {
    const view = viewOf([[0, 0]]);
    view.show({ minX: 200, maxX: 260, minY: 0, maxY: 40 });
    view.size.value = { width: 700, height: 500 };
    view.covered.value = 100;
    const corner = toScreen(view.camera.value, [260, 0]);
    expect(corner.x).toBeLessThan(700);
    expect(corner.y).toBeLessThan(500 - 100);
    view.fit();
    expect(toScreen(view.camera.value, [0, 0]).x).toBeGreaterThan(0);
    expect(toScreen(view.camera.value, [0, 0]).x).toBeLessThan(700);
  });

  it("zooming keeps the place under the pointer and stops at the limits", () => {
    const view = viewOf([]);
    const at = { x: 300, y: 200 };
    const place = toStage(view.camera.value, at);
    view.zoomBy(3, at);
    const kept = toScreen(view.camera.value, place);
    expect(kept.x).toBeCloseTo(at.x, 6);
    expect(kept.y).toBeCloseTo(at.y, 6);
    for (let turn = 0; turn < 50; turn += 1) view.zoomBy(0.5);
    expect(view.zoom.value).toBeGreaterThan(0.02);
    for (let turn = 0; turn < 50; turn += 1) view.zoomBy(2);
    expect(view.zoom.value).toBeLessThan(65);
  });
});
