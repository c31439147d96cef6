import fc from "fast-check";
import { expect, test } from "vitest";
import type { Point } from "../document/formation";
import { distance, placesAlong, shareOut } from "./path";
import { isInside } from "./polygon";
import { extended, isClosedStroke, isMeant, smoothed, strokePlaces } from "./stroke";

const circle = (radius: number, corners = 80): Point[] =>
  Array.from({ length: corners }, (_, i) => [
    radius * Math.cos((2 * Math.PI * i) / corners),
    radius * Math.sin((2 * Math.PI * i) / corners),
  ]);

/** A U: what is nearest in it need not be reachable in a straight line. */
const HORSESHOE: readonly Point[] = [
  [0, 0],
  [12, 0],
  [12, 10],
  [9, 10],
  [9, 3],
  [3, 3],
  [3, 10],
  [0, 10],
];

const SPIRAL: readonly Point[] = [
  ...Array.from({ length: 60 }, (_, i): Point => {
    const angle = (i / 60) * 3.5 * Math.PI;
    return [(4 + angle) * Math.cos(angle), (4 + angle) * Math.sin(angle)];
  }),
];

const REGIONS: readonly (readonly [string, readonly Point[]])[] = [
  ["a circle", circle(10)],
  ["a horseshoe", HORSESHOE],
  [
    "a thin sliver",
    [
      [0, 0],
      [30, 1],
      [30, 2],
      [0, 1],
    ],
  ],
  ["a path that winds over itself", SPIRAL],
];

function nearestDistances(places: readonly Point[]): number[] {
  return places.map((place, i) =>
    places.reduce((least, other, j) => (i === j ? least : Math.min(least, distance(place, other))), Infinity),
  );
}

function unevenness(values: readonly number[]): number {
  const mean = values.reduce((sum, value) => sum + value, 0) / values.length;
  const variance = values.reduce((sum, value) => sum + (value - mean) ** 2, 0) / values.length;
  return Math.sqrt(variance) / mean;
}

test.each(REGIONS)("%s is filled with exactly as many as asked, all inside and apart", (_, region) => {
  for (const count of [1, 2, 5, 30, 200]) {
    const places = strokePlaces(region, "filled", { by: "count", count });
    expect(places).toHaveLength(count);
    for (const place of places) expect(isInside(region, place)).toBe(true);
    expect(new Set(places.map(String)).size).toBe(count);
  }
});

// Random places have unevenness √(4/π − 1) = 0.52, a lattice 0. Relaxed cells come to about 0.1; 0.2 is well off chance.
test.each(REGIONS)("%s is filled evenly", (_, region) => {
  for (const count of [100, 300, 1260]) {
    const nearest = nearestDistances(strokePlaces(region, "filled", { by: "count", count }));
    expect(unevenness(nearest)).toBeLessThan(0.2);
  }
});

test("filling by interval keeps neighbors about that far apart", () => {
  const nearest = nearestDistances(strokePlaces(circle(12), "filled", { by: "interval", meters: 1.2 }));
  const mean = nearest.reduce((sum, value) => sum + value, 0) / nearest.length;
  // The triangular lattice of the same density has exactly 1.2; nearest neighbors of a relaxed one are up to a sixth closer.
  expect(mean).toBeGreaterThan(1);
  expect(mean).toBeLessThan(1.21);
});

test("the same region is filled the same way again", () => {
  const fill = () => strokePlaces(HORSESHOE, "filled", { by: "count", count: 60 });
  expect(fill()).toEqual(fill());
});

test("a closed stroke without an inside is lined", () => {
  const there: Point[] = [
    [0, 0],
    [4, 0],
    [8, 0],
    [4, 0],
  ];
  expect(strokePlaces(there, "filled", { by: "count", count: 9 })).toHaveLength(9);
});

test("agents stand evenly along any stroke, both ends occupied", () => {
  const point = fc.tuple(fc.double({ min: -50, max: 50, noNaN: true }), fc.double({ min: -50, max: 50, noNaN: true }));
  fc.assert(
    fc.property(fc.array(point, { minLength: 2, maxLength: 20 }), fc.integer({ min: 2, max: 60 }), (stroke, count) => {
      const places = placesAlong(stroke, { by: "count", count });
      expect(places).toHaveLength(count);
      const [first, last] = [stroke[0], stroke.at(-1)];
      expect(distance(places[0] ?? [NaN, 0], first ?? [0, 0])).toBeLessThan(1e-9);
      expect(distance(places.at(-1) ?? [NaN, 0], last ?? [0, 0])).toBeLessThan(1e-9);
      const total = stroke.slice(1).reduce((sum, p, i) => sum + distance(stroke[i] ?? p, p), 0);
      // A straight line between two of them is never longer than their share of the stroke.
      for (const [i, place] of places.slice(1).entries()) {
        expect(distance(places[i] ?? place, place)).toBeLessThanOrEqual(total / (count - 1) + 1e-9);
      }
    }),
  );
});

test("an interval along a stroke is kept from its start", () => {
  const places = strokePlaces(
    [
      [0, 0],
      [10.5, 0],
    ],
    "open",
    { by: "interval", meters: 2 },
  );
  expect(places.map(([x]) => x)).toEqual([0, 2, 4, 6, 8, 10]);
});

test("an outline goes once around without meeting itself", () => {
  const places = strokePlaces(circle(10), "outline", { by: "count", count: 40 });
  const gaps = places.map((place, i) => distance(place, places[(i + 1) % 40] ?? place));
  expect(unevenness(gaps)).toBeLessThan(1e-3);
});

test("a stroke that comes back to its start is closed, one that ends elsewhere or went nowhere is not", () => {
  expect(isClosedStroke(circle(10), 1)).toBe(true);
  expect(isClosedStroke(circle(10).slice(0, 60), 1)).toBe(false);
  expect(isClosedStroke(circle(0.5), 1)).toBe(false);
});

test("trembling on one spot adds nothing to a stroke", () => {
  const start: readonly Point[] = [[0, 0]];
  expect(extended(start, [0.01, 0], 0.1)).toBe(start);
  expect(extended(start, [0.2, 0], 0.1)).toHaveLength(2);
  expect(isMeant(start, 0.1)).toBe(false);
});

test("smoothing keeps the ends and takes the tremble out", () => {
  const zigzag = Array.from({ length: 21 }, (_, i): Point => [i, i % 2 === 0 ? 0 : 0.4]);
  const smooth = smoothed(zigzag);
  expect(smooth[0]).toEqual(zigzag[0]);
  expect(smooth.at(-1)).toEqual(zigzag.at(-1));
  const roughness = (path: readonly Point[]) =>
    path.slice(1).reduce((sum, p, i) => sum + Math.abs(p[1] - (path[i]?.[1] ?? 0)), 0);
  expect(roughness(smooth)).toBeLessThan(roughness(zigzag) / 4);
});

test("shares add up and follow the weights", () => {
  expect(shareOut(7, [1, 1, 1])).toEqual([3, 2, 2]);
  expect(shareOut(10, [3, 1, 1])).toEqual([6, 2, 2]);
  expect(shareOut(0, [1, 2])).toEqual([0, 0]);
});
