import { expect, test } from "vitest";
import { mostApart, widestApart } from "./spread";

test.each([
  [6, 4, 35, 1],
  [8, 3, 3, 4],
  [6, 4, 6, 3],
])("on %d × %d m %d agents fit %d m apart", (width, depth, count, distance) => {
  expect(widestApart(width, depth, count)).toBe(distance);
  expect(mostApart(width, depth, distance)).toBeGreaterThanOrEqual(count);
});

test("more than a lattice holds is too many, and no distance is none to hold", () => {
  expect(mostApart(6, 4, 1)).toBeLessThan(40);
  expect(mostApart(8, 3, 30)).toBe(1);
  expect(mostApart(6, 4, 0)).toBe(Number.POSITIVE_INFINITY);
});
