import { expect, test } from "vitest";
import type { Point } from "./formation";
import { crossesItself, distanceTo, middleOf, nearestOn, shapeMoved } from "./obstacle";
import type { ObstacleShape } from "./scene";

const CIRCLE: ObstacleShape = { kind: "circle", center: [2, 1], radius: 2 };
/** An L: the notch is empty. */
const ELL: ObstacleShape = {
  kind: "polygon",
  points: [
    [0, 0],
    [4, 0],
    [4, 1],
    [1, 1],
    [1, 4],
    [0, 4],
  ],
};

test.each<readonly [string, ObstacleShape, Point, number]>([
  ["beside a circle", CIRCLE, [6, 1], 2],
  ["in a circle", CIRCLE, [2.5, 1], 0],
  ["in the middle of a circle", CIRCLE, [2, 1], 0],
  ["beside a side of an L", ELL, [-3, 2], 3],
  ["beyond a corner of an L", ELL, [7, -4], 5],
  ["in the arm of an L", ELL, [0.5, 3], 0],
  ["in the notch of an L", ELL, [3, 3], 2],
])("a place %s is so far away", (_, shape, at, distance) => {
  expect(distanceTo(shape, at)).toBeCloseTo(distance, 9);
});

test("what is nearest lies on the outline", () => {
  expect(nearestOn(CIRCLE, [2, 7])).toEqual([2, 3]);
  expect(nearestOn(CIRCLE, [2, 1])).toEqual([4, 1]);
  expect(nearestOn(ELL, [2, 3])).toEqual([1, 3]);
});

test("a moved outline is the same elsewhere", () => {
  for (const shape of [CIRCLE, ELL]) {
    const [x, y] = middleOf(shape);
    const [movedX, movedY] = middleOf(shapeMoved(shape, [3, -2]));
    expect(movedX).toBeCloseTo(x + 3, 9);
    expect(movedY).toBeCloseTo(y - 2, 9);
    expect(distanceTo(shapeMoved(shape, [3, -2]), [10, 3])).toBeCloseTo(distanceTo(shape, [7, 5]), 9);
  }
});

test.each<readonly [string, readonly Point[], boolean]>([
  ["an L", ELL.kind === "polygon" ? ELL.points : [], false],
  ["a bow whose first side crosses", bow([4, 4], [4, 0], [0, 3]), true],
  ["a bow whose last side crosses", bow([4, 0], [0, 3], [4, 3]), true],
  ["a corner on another side", bow([4, 0], [4, 4], [2, 0], [0, 4]), false],
  ["a corner twice", bow([4, 0], [4, 0], [4, 2]), false],
])("%s crosses itself or not", (_, points, crosses) => {
  expect(crossesItself(points)).toBe(crosses);
});

function bow(...points: Point[]): readonly Point[] {
  return [[0, 0], ...points];
}
