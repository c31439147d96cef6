import { expect, test } from "vitest";
import { status } from "./status";

test("nearer than the minimum distance is a clash, exactly at it is not", () => {
  expect(status(0.49, 0.5)).toBe("clash");
  expect(status(0.5, 0.5)).toBe("tight");
});

test("a tenth above the minimum distance it holds", () => {
  expect(status(1.0999, 1)).toBe("tight");
  expect(status(1.1, 1)).toBe("holds");
});

test("without a pair or a limit there is nothing to hold", () => {
  expect(status(null, 0.5)).toBe("none");
  expect(status(0.1, 0)).toBe("none");
});
