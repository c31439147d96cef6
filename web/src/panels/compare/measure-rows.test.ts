import { expect, test } from "vitest";
import type { SegmentReport } from "../../engine/api";
import { measureRows } from "./measure-rows";

const LEFT: SegmentReport = {
  choice: { method: "linear", order: "greedy", alignment: "pca", sharing: 0 },
  distortion: { mean: 0.4, max: 0.9 },
  turning: { mean: 1, max: 2 },
  clearance: { distance: 0.1, time: 1, agents: [0, 1] },
  nearCollisions: 3,
  pathLength: { mean: 5, max: 7 },
  topSpeed: { speed: 2, time: 1, agent: 0 },
  rmsRadius: { min: 1, max: 2 },
  candidates: [],
};
const RIGHT: SegmentReport = {
  ...LEFT,
  distortion: { mean: 0.2, max: 0.9 },
  clearance: { distance: 0.5, time: 1, agents: [0, 1] },
  pathLength: { mean: 6, max: 8 },
};

function betterOf(label: string, rows = measureRows(LEFT, RIGHT, "m")) {
  return rows.find((row) => row.label === label)?.better;
}

test("more clearance is better, less of all else", () => {
  expect(betterOf("Clearance")).toBe("right");
  expect(betterOf("Distortion")).toBe("right");
  expect(betterOf("Path length")).toBe("left");
});

test("what reads the same is no better", () => {
  expect(betterOf("Near collisions")).toBe("neither");
  const close = { ...RIGHT, distortion: { mean: 0.4004, max: 0.9 } };
  expect(betterOf("Distortion", measureRows(LEFT, close, "m"))).toBe("neither");
});

test("one agent alone has no clearance, and while one side is planned nothing is judged", () => {
  const alone = { ...LEFT, clearance: null };
  expect(measureRows(alone, alone, "m")[0]).toEqual({ label: "Clearance", left: null, right: null, better: "neither" });
  expect(measureRows(LEFT, null, "m").every((row) => row.better === "neither" && row.right === null)).toBe(true);
});

test("what avoidance did is told where a side avoids, and left out where none does", () => {
  expect(measureRows(LEFT, RIGHT, "m").some(({ label }) => label === "Unsolved")).toBe(false);
  const avoiding = { ...RIGHT, deviation: { mean: 0.1, max: 0.2 }, unsolved: [] };
  const rows = measureRows(LEFT, avoiding, "m");
  expect(rows.find(({ label }) => label === "Moved to avoid")).toMatchObject({ left: null, right: "0.20 m" });
  expect(rows.find(({ label }) => label === "Unsolved")?.right).toBe("0");
});
