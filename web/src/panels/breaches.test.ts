import { expect, test } from "vitest";
import { Formation } from "../document/formation";
import { breachesOf } from "./breaches";

const THREE = Formation.from([
  [0, 0],
  [0.4, 0],
  [0.4, 0.3],
]);

test("who stands too near is named, worst first", () => {
  expect(breachesOf(THREE, 0.5).map(({ a, b }) => [a, b])).toEqual([
    [1, 2],
    [0, 1],
  ]);
  expect(breachesOf(THREE, 0.5)[0]?.distance).toBeCloseTo(0.3, 6);
});

test("exactly the minimum distance is kept, in any units the stage may have", () => {
  const yards = Formation.from([
    [100 * 0.9144, 0],
    [100 * 0.9144 + 0.5, 0],
  ]);
  expect(breachesOf(yards, 0.5)).toEqual([]);
});

test("another minimum distance has another answer, and none has none", () => {
  expect(breachesOf(THREE, 0.35)).toHaveLength(1);
  expect(breachesOf(THREE, 0)).toEqual([]);
});
