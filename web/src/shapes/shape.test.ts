import { expect, test } from "vitest";
import type { Point } from "../document/formation";
import { distance } from "./path";
import { placeShape, type ShapeName } from "./shape";

const SHAPES: readonly ShapeName[] = ["line", "arc", "circle", "ring", "block", "grid", "triangle", "star"];
const COUNTS = [1, 2, 3, 4, 5, 7, 10, 25, 90, 299, 1260] as const;
const DRAGS: readonly (readonly [Point, Point])[] = [
  [
    [-10, -6],
    [14, 9],
  ],
  [
    [14, 9],
    [-10, -6],
  ],
  [
    [3, 20],
    [4, -20],
  ],
];
/** Drags that give a box no width or no depth. */
const FLAT: readonly (readonly [Point, Point])[] = [
  [
    [0, 0],
    [12, 0],
  ],
  [
    [0, 0],
    [0, -12],
  ],
];

function leastDistance(places: readonly Point[]): number {
  const ordered = places.toSorted((a, b) => a[0] - b[0]);
  let least = Number.POSITIVE_INFINITY;
  for (const [i, place] of ordered.entries()) {
    for (let j = i + 1; j < ordered.length; j += 1) {
      const other = ordered[j] ?? place;
      if (other[0] - place[0] >= least) break;
      least = Math.min(least, distance(place, other));
    }
  }
  return least;
}

test.each(SHAPES)("%s has exactly as many places as asked, no two alike, inside the drag", (name) => {
  for (const [from, to] of [...DRAGS, ...FLAT]) {
    const reach = Math.max(Math.abs(to[0] - from[0]), Math.abs(to[1] - from[1]));
    for (const count of COUNTS) {
      const { places } = placeShape(name, from, to, { by: "count", count });
      expect(places).toHaveLength(count);
      expect(leastDistance(places)).toBeGreaterThan(1e-4);
      for (const place of places) expect(distance(place, from)).toBeLessThanOrEqual(2 * reach);
    }
  }
});

test.each(SHAPES)("%s by interval keeps the interval", (name) => {
  // In a corner as sharp as the narrow drag gives, the two edges come nearer to each other than any interval.
  const drags = name === "triangle" || name === "star" ? DRAGS.slice(0, 2) : DRAGS;
  for (const [from, to] of drags) {
    const { places } = placeShape(name, from, to, { by: "interval", meters: 1.5 });
    const least = leastDistance(places);
    // Around a closed path whole places come as near to the interval as they can; a chord is a little shorter than its arc.
    expect(least).toBeGreaterThan(1.5 * 0.6);
    if (["line", "grid", "block"].includes(name)) expect(least).toBeCloseTo(1.5, 9);
  }
});

test.each(SHAPES)("%s is the same when it is drawn again", (name) => {
  const [from, to] = [
    [-3, 2],
    [8, 7],
  ] as const;
  const draw = () => placeShape(name, from, to, { by: "count", count: 37 });
  expect(draw()).toEqual(draw());
});

test("both ends of a line are occupied and the rest is even between", () => {
  const { places } = placeShape("line", [0, 0], [9, 0], { by: "count", count: 10 });
  expect(places.map(([x]) => x)).toEqual([0, 1, 2, 3, 4, 5, 6, 7, 8, 9]);
});

test("one agent stands in the middle of a line", () => {
  expect(placeShape("line", [0, 0], [9, 0], { by: "count", count: 1 }).places).toEqual([[4.5, 0]]);
});

test("an arc stands on its two ends and its top", () => {
  for (const height of [1, 5, 9, -4]) {
    const { places } = placeShape("arc", [0, 0], [10, height], { by: "count", count: 5 });
    const expected: Point[] = [
      [0, 0],
      [5, height],
      [10, 0],
    ];
    for (const [i, place] of expected.entries()) {
      expect(places[2 * i]?.[0]).toBeCloseTo(place[0], 9);
      expect(places[2 * i]?.[1]).toBeCloseTo(place[1], 9);
    }
  }
});

test("a circle is evenly spaced all around", () => {
  const { places } = placeShape("circle", [0, 0], [10, 10], { by: "count", count: 12 });
  for (const [i, place] of places.entries()) {
    expect(distance(place, [5, 5])).toBeCloseTo(5, 12);
    expect(distance(place, places[(i + 1) % 12] ?? place)).toBeCloseTo(2 * 5 * Math.sin(Math.PI / 12), 12);
  }
});

test("a ring has two circles spaced alike", () => {
  const { places } = placeShape("ring", [0, 0], [20, 20], { by: "count", count: 80 });
  const radii = new Set(places.map((place) => Math.round(distance(place, [10, 10]) * 1e6) / 1e6));
  expect([...radii].sort((a, b) => a - b)).toEqual([6, 10]);
  const inside = places.filter((place) => distance(place, [10, 10]) < 8).length;
  // Each circle's count is off by half a place at most: 1/60 of the spacing at 30 places inside.
  expect((2 * Math.PI * 6) / inside / ((2 * Math.PI * 10) / (80 - inside))).toBeCloseTo(1, 1);
});

test("a grid of a count that fits has full rows", () => {
  const { places } = placeShape("grid", [0, 0], [8, 4], { by: "count", count: 45 });
  expect(new Set(places.map(([x]) => x))).toEqual(new Set([0, 1, 2, 3, 4, 5, 6, 7, 8]));
  expect(new Set(places.map(([, y]) => y))).toEqual(new Set([0, 1, 2, 3, 4]));
});

test("every other row of a block is set half a step aside", () => {
  const { places } = placeShape("block", [0, 0], [10, 6], { by: "interval", meters: 2 });
  const starts = places.filter(([, y], i) => y !== places[i - 1]?.[1]).map(([x]) => x);
  expect(starts).toEqual([0, 1, 0, 1]);
});

test("the corners of triangle and star are occupied", () => {
  const triangle = placeShape("triangle", [0, 0], [10, 8], { by: "count", count: 20 });
  for (const corner of triangle.outline) expect(triangle.places).toContainEqual(corner);
  const star = placeShape("star", [0, 0], [10, 10], { by: "count", count: 23 });
  for (const corner of star.outline) expect(star.places).toContainEqual(corner);
});
