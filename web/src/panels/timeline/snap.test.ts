import { expect, test } from "vitest";
import { snapTime } from "./snap";

const SCENE = { frameRate: 30, tempo: { beatsPerMinute: 120, beatsPerBar: 4, start: 0 } };
const SLOW = { frameRate: 30, tempo: { beatsPerMinute: 80, beatsPerBar: 4, start: 0.2 } };

test.each([
  ["the half second it comes near", 4.03, 80, [], 4],
  ["the playhead it comes near", 4.27, 80, [4.2512], 4.2512],
  ["the nearer of the two", 4.03, 80, [4.05], 4.05],
  ["the nearest frame away from all", 4.21, 80, [], 126 / 30],
  ["frames only where half seconds would leave no place between them", 4.03, 20, [], 121 / 30],
  ["the start, never before it", -3, 80, [], 0],
])("a time dragged along seconds sticks to %s", (_, time, pixelsPerSecond, times, expected) => {
  expect(snapTime(time, SCENE, { pixelsPerSecond, times, ruler: "seconds" })).toBeCloseTo(expected, 9);
});

test.each([
  ["the nearest count, however far", 4.3, 80, [], 0.2 + 5 * 0.75],
  ["the nearest count, however many there are", 4.3, 8, [], 0.2 + 5 * 0.75],
  ["the playhead it comes near", 4.3, 80, [4.31], 4.31],
  ["frames before the first count", 0.01, 80, [], 0.2],
])("a time dragged along counts sticks to %s", (_, time, pixelsPerSecond, times, expected) => {
  expect(snapTime(time, SLOW, { pixelsPerSecond, times, ruler: "counts" })).toBeCloseTo(expected, 9);
});
