import { expect, test } from "vitest";
import { nextStop } from "./roving";

test("arrows go around the ends", () => {
  expect(nextStop("ArrowDown", 2, 3)).toBe(0);
  expect(nextStop("ArrowLeft", 0, 3)).toBe(2);
});

test("Home and End lead to the ends, letters nowhere", () => {
  expect(nextStop("Home", 2, 3)).toBe(0);
  expect(nextStop("End", 0, 3)).toBe(2);
  expect(nextStop("x", 0, 3)).toBeNull();
});

test("the first arrow into a list enters at its near end", () => {
  expect(nextStop("ArrowDown", -1, 3)).toBe(0);
  expect(nextStop("ArrowUp", -1, 3)).toBe(2);
});

test("an empty list has nowhere to go", () => {
  expect(nextStop("Home", -1, 0)).toBeNull();
});
