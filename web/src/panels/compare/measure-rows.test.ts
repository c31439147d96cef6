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

function bestOf(label: string, rows = measureRows([LEFT, RIGHT], "m")) {
  return rows.find((row) => row.label === label)?.best;
}

test("more clearance is better, less of all else", () => {
  expect(bestOf("Clearance")).toBe(1);
  expect(bestOf("Distortion")).toBe(1);
  expect(bestOf("Path length")).toBe(0);
});

test("what reads the same is no better", () => {
  expect(bestOf("Near collisions")).toBeNull();
  const close = { ...RIGHT, distortion: { mean: 0.4004, max: 0.9 } };
  expect(bestOf("Distortion", measureRows([LEFT, close], "m"))).toBeNull();
});

test("one agent alone has no clearance, and while one side is planned nothing is judged", () => {
  const alone = { ...LEFT, clearance: null };
  expect(measureRows([alone, alone], "m")[0]).toEqual({ label: "Clearance", values: [null, null], best: null });
  expect(measureRows([LEFT, null], "m").every(({ values, best }) => best === null && values[1] === null)).toBe(true);
});

test("what avoidance did is told where a way avoids, and left out where none does", () => {
  expect(measureRows([LEFT, RIGHT], "m").some(({ label }) => label === "Unsolved")).toBe(false);
  const avoiding = { ...RIGHT, deviation: { mean: 0.1, max: 0.2 }, unsolved: [], guideClearance: LEFT.clearance };
  const rows = measureRows([LEFT, avoiding], "m");
  const told = (label: string) => rows.find((row) => row.label === label)?.values;
  expect(told("before avoiding")).toEqual([null, "0.10 m"]);
  expect(told("Moved to avoid")).toEqual([null, "0.20 m"]);
  expect(told("Unsolved")).toEqual([null, "0"]);
});

test("of several ways the one that is better than all others is marked", () => {
  const rows = measureRows([LEFT, RIGHT, LEFT, RIGHT], "m");
  expect(bestOf("Distortion", rows)).toBeNull();
  const third = { ...LEFT, distortion: { mean: 0.1, max: 0.9 } };
  expect(bestOf("Distortion", measureRows([LEFT, RIGHT, third], "m"))).toBe(2);
});
