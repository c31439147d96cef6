import { expect, test } from "vitest";
import { snapTime } from "./snap";

const SCENE = { frameRate: 30, tempo: { beatsPerMinute: 120, beatsPerBar: 4, start: 0 } };

test.each([
  ["the beat it comes near", 4.03, 80, [], 4],
  ["the playhead it comes near", 4.27, 80, [4.2512], 4.2512],
  ["the nearer of the two", 4.03, 80, [4.05], 4.05],
  ["the nearest frame away from all", 4.21, 80, [], 126 / 30],
  ["frames only where beats would leave no place between them", 4.03, 20, [], 121 / 30],
  ["the start, never before it", -3, 80, [], 0],
])("a dragged time sticks to %s", (_, time, pixelsPerSecond, times, expected) => {
  expect(snapTime(time, SCENE, { pixelsPerSecond, times })).toBeCloseTo(expected, 9);
});
