import { expect, test } from "vitest";
import type { SegmentReport } from "../../engine/api";
import type { SalvageReport } from "../../engine/salvage";
import { spreadRows } from "./spread-rows";

const AFTER: SalvageReport = {
  clearance: { distance: 0.52, time: 1, agents: [0, 1] },
  deviation: { mean: 0.2, max: 1.5 },
  topSpeed: 3,
  guideTopSpeed: 2,
  isWild: false,
  unsolved: [],
};

const BEFORE: SegmentReport = {
  choice: { method: "linear", order: "greedy", alignment: "pca", sharing: 0 },
  distortion: { mean: 0, max: 0 },
  turning: { mean: 0, max: 0 },
  clearance: { distance: 0.31, time: 1, agents: [0, 1] },
  deviation: { mean: 0.1, max: 0.4 },
  nearCollisions: 1,
  pathLength: { mean: 1, max: 1 },
  topSpeed: { speed: 2.2, time: 1, agent: 0 },
  rmsRadius: { min: 1, max: 1 },
  candidates: [],
};

test("each number stands beside the one before, speeds as multiples of the method's own", () => {
  expect(spreadRows(BEFORE, AFTER, "m")).toEqual([
    { label: "Nearest", was: "0.31 m", now: "0.52 m" },
    { label: "Farthest aside", was: "0.40 m", now: "1.50 m" },
    { label: "Top speed", was: "× 1.10", now: "× 1.50" },
  ]);
});

test("what is not known is a dash", () => {
  expect(spreadRows(null, { ...AFTER, clearance: null }, "m").map(({ was, now }) => [was, now])).toEqual([
    ["–", "–"],
    ["–", "1.50 m"],
    ["–", "× 1.50"],
  ]);
});
