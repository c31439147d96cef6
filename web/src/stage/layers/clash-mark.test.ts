import { expect, test } from "vitest";
import { clashReach } from "./clash-mark";

test("a ring reaches no farther than what lies between the two and their discs, however large the minimum distance", () => {
  const disc = 14;
  for (const minimum of [10, 30, 300, 3000]) {
    for (const share of [0, 0.3, 0.9]) {
      const distance = minimum * share;
      expect(clashReach(minimum, distance, disc)).toBeLessThanOrEqual(distance + disc);
    }
  }
});

test("a ring is as wide as the minimum distance where that tells something, and never within a disc", () => {
  expect(clashReach(36, 25, 14)).toBe(36);
  expect(clashReach(1, 0, 14)).toBe(14);
});
