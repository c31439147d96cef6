import { expect, test } from "vitest";
import { isPathData } from "./path-check";

test.each([
  "M 0 0 L 4 0 L 2 3 Z",
  "m0,0 4 0-2,3z",
  "M.5.5h1e1v-2.5Zm3 3h1v1z",
  "M0 0C1 1 2 2 3 3S5 5 6 6Q7 7 8 8T9 9",
  "M0 0a1 1 0 01 2 2z",
])("%s is a path", (data) => expect(isPathData(data)).toBe(true));

test.each(["garbage", "L 4 0 L 2 3 Z", "M 0 0 L 4", "M 0 0 L x 4", "M 0 0 Z 3", "M", "M 0 0 L 4 0;", "0 0"])(
  "%s is none",
  (data) => expect(isPathData(data)).toBe(false),
);
