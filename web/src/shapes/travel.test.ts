import fc from "fast-check";
import { expect, test } from "vitest";
import { cutPath } from "../document/cut-path";
import { Formation, type Point } from "../document/formation";
import { CENTIMETER } from "../document/snap";
import {
  bowBetween,
  crosses,
  curveThrough,
  followed,
  lengthAlong,
  pathOfStroke,
  turnAlong,
  turnBetween,
} from "./travel";

const coordinate = fc.integer({ min: -50, max: 50 });
const place = fc.tuple(coordinate, coordinate);

function arc(count: number, radius: number, angle: number): Point[] {
  return Array.from({ length: count }, (_, k) => {
    const turn = (angle * k) / (count - 1);
    return [radius * Math.sin(turn), radius * (1 - Math.cos(turn))];
  });
}

test("a path is followed from one barycenter to the other, wherever it was drawn", () => {
  fc.assert(
    fc.property(fc.array(place, { minLength: 2, maxLength: 9 }), place, place, (points, from, to) => {
      const line = followed(points, from, to);
      expect([line[0], line.at(-1)]).toEqual([from, to]);
      expect(line.every((point) => point.every(Number.isFinite))).toBe(true);
    }),
  );
});

test("a straight path is the straight way", () => {
  const line = curveThrough(
    followed(
      [
        [0, 0],
        [1, 2],
        [10, 20],
      ],
      [5, 5],
      [9, 5],
    ),
  );
  for (const [x, y] of line) {
    expect(y).toBeCloseTo(5, 12);
    expect(x).toBeGreaterThanOrEqual(5 - 1e-12);
  }
  expect(lengthAlong(line)).toBeCloseTo(4, 12);
});

test("a curve is that of the circle its points are on", () => {
  const line = curveThrough(arc(9, 10, Math.PI / 2));
  // A chord's sagitta, 10 · (π/16)²/8, is more than a spline is off.
  for (const [x, y] of line) expect(Math.abs(Math.hypot(x, y - 10) - 10)).toBeLessThan(0.05);
  // Chords of the line turn by one step less than the circle.
  expect(turnAlong(line)).toBeGreaterThan(Math.PI / 2 - 0.1);
  expect(turnAlong(line)).toBeLessThan(Math.PI / 2 + 0.02);
});

test("a stroke is kept in few points, near to how it was drawn, and from source to target", () => {
  const stroke = arc(80, 10, Math.PI / 2);
  for (const drawn of [stroke, stroke.toReversed()]) {
    const path = pathOfStroke(drawn, [0, 0], [10, 10], CENTIMETER);
    expect(path?.[0]).toEqual([0, 0]);
    expect(path?.at(-1)).toEqual([10, 10]);
    expect(path?.length).toBeLessThan(9);
    for (const [x, y] of curveThrough(path ?? [])) expect(Math.abs(Math.hypot(x, y - 10) - 10)).toBeLessThan(0.3);
  }
  expect(
    pathOfStroke(
      [
        [1, 1],
        [1, 1],
      ],
      [0, 0],
      [10, 10],
      CENTIMETER,
    ),
  ).toBeNull();
});

test("a bow leads from place to place, and around when they are one", () => {
  expect(bowBetween([0, 0], [8, 0], CENTIMETER)[2]).toEqual([4, 2]);
  const loop = bowBetween([3, 3], [3, 3], CENTIMETER);
  expect([loop[0], loop.at(-1)]).toEqual([
    [3, 3],
    [3, 3],
  ]);
  expect(lengthAlong(curveThrough(loop))).toBeGreaterThan(20);
});

test("who crosses their own way is told, who turns a corner is not", () => {
  expect(
    crosses([
      [0, 0],
      [4, 4],
      [4, 0],
      [0, 4],
    ]),
  ).toBe(true);
  expect(
    crosses([
      [0, 0],
      [4, 0],
      [4, 4],
      [0, 4],
    ]),
  ).toBe(false);
});

test("who comes back to a point of their way is told, who only ends where they began is not", () => {
  const eight: Point[] = [
    [-5, 0],
    [0, 0],
    [5, 5],
    [0, 5],
    [0, 0],
    [0, -5],
  ];
  expect(crosses(eight)).toBe(true);
  expect(crosses(curveThrough(eight))).toBe(true);
  expect(crosses(curveThrough(bowBetween([0, 0], [0, 0], CENTIMETER)))).toBe(false);
});

test("the turn between formations is that of least squares", () => {
  const shape = Formation.from([
    [0, 0],
    [4, 0],
    [5, 2],
  ]);
  const turned = Formation.from(shape.points().map(([x, y]): Point => [7 - y, x]));
  expect(turnBetween(shape, turned)).toBeCloseTo(Math.PI / 2, 12);
});

test("a path is cut where it comes nearest, and no part is without a length", () => {
  const here = (x: number, y: number) =>
    Formation.from([
      [x - 1, y],
      [x + 1, y],
    ]);
  expect(
    cutPath(
      [
        [0, 0],
        [10, 0],
        [10, 10],
      ],
      here(4, 1),
    ),
  ).toEqual([
    [
      [0, 0],
      [4, 0],
    ],
    [
      [4, 0],
      [10, 0],
      [10, 10],
    ],
  ]);
  expect(
    cutPath(
      [
        [0, 0, 1],
        [10, 0, 3],
      ],
      here(5, 0),
    ),
  ).toEqual([
    [
      [0, 0, 1],
      [5, 0, 2],
    ],
    [
      [5, 0, 2],
      [10, 0, 3],
    ],
  ]);
  expect(
    cutPath(
      [
        [0, 0],
        [10, 0],
      ],
      here(-3, 0),
    )[0],
  ).toBeNull();
});
