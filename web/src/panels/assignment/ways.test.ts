import { expect, test } from "vitest";
import { Formation } from "../../document/formation";
import { SegmentMotion } from "../../playback/motion";
import { waysAlong } from "./ways";

const to = Formation.from([
  [4, 0],
  [4, 4],
]);
/** The first goes around above, the second straight. */
const motion = new SegmentMotion(
  new Float64Array([0, 1, 2]),
  new Float32Array([0, 0, 0, 4, 2, 3, 2, 4, 4, 0, 4, 4]),
  2,
);
const below = [[[2, -3]], []] as const;

test("who keeps a place goes as the motion does, and who takes another's as the shortest way", () => {
  expect(waysAlong(motion, to, [0, 1], below)).toEqual([[[2, 3]], [[2, 4]]]);
  expect(waysAlong(motion, to, [1, 0], below)).toEqual(below);
});

test("a motion that is not there, or led elsewhere, is not followed", () => {
  expect(waysAlong(null, to, [0, 1], below)).toBe(below);
  const moved = to.with([[0, [9, 0]]]);
  expect(waysAlong(motion, moved, [0, 1], below)).toEqual([[[2, -3]], [[2, 4]]]);
});
