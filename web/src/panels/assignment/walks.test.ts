import { expect, test } from "vitest";
import { Formation } from "../../document/formation";
import { nearestTo, walksOf } from "./walks";

const FROM = new Formation(Float64Array.of(0, 0, 4, 0), Float64Array.of(0, 0));
const TO = new Formation(Float64Array.of(3, 4, 4, 0), Float64Array.of(12, 0));

test("walks go straight, heights included, and the longest has a name", () => {
  expect(walksOf(FROM, TO)).toEqual({ total: 13, longest: 13, who: 0 });
  const crossed = walksOf(FROM, TO, [], [1, 0]);
  expect(crossed.who).toBe(1);
  // √(1² + 4² + 12²) and 4.
  expect(crossed.total).toBeCloseTo(Math.sqrt(161) + 4, 12);
  expect(walksOf(Formation.from([]), Formation.from([]))).toEqual({ total: 0, longest: 0, who: -1 });
});

test("a way around something is as long as its pieces", () => {
  const bends = [[[0, 3]], []] as const;
  // 3 up, √(3² + 1²) to the side, and 12 in height.
  expect(walksOf(FROM, TO, bends).longest).toBeCloseTo(Math.hypot(3 + Math.sqrt(10), 12), 12);
});

test("the nearest within reach is meant, else nobody", () => {
  expect(nearestTo([3, 0], FROM, 2)).toBe(1);
  expect(nearestTo([2, 5], FROM, 2)).toBeNull();
});
