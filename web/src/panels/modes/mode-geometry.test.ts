import { describe, expect, test } from "vitest";
import { Formation } from "../../document/formation";
import { MATCH_ORDERS, ModeBasis, ModeMatch } from "../../engine/modes";
import {
  coefficientsOf,
  cutLine,
  cutPairs,
  likenessAlong,
  pairsAmong,
  partialFormation,
  rmsError,
  sidesOf,
} from "./mode-geometry";

/** A path of three with unit ties: eigenvalues 0, 1, 3, modes known by hand. */
const HALF = Math.SQRT1_2;
const SIXTH = 1 / Math.sqrt(6);
const PATH = new ModeBasis(Float64Array.of(0, 1, 3), Float64Array.of(HALF, 0, -HALF, SIXTH, -2 * SIXTH, SIXTH));
const BENT = Formation.from([
  [0, 0],
  [2, 1],
  [5, 0],
]);

describe("a formation and its modes", () => {
  test("all modes together give the formation back", () => {
    const whole = partialFormation(PATH, coefficientsOf(PATH, BENT), 3);
    // Sums of three products of numbers below 10.
    for (const [k, value] of whole.entries()) expect(value).toBeCloseTo(BENT.xy[k] ?? Number.NaN, 12);
    expect(rmsError(whole, BENT)).toBeLessThan(1e-12);
  });

  test("the first mode alone is everybody in the barycenter", () => {
    const first = partialFormation(PATH, coefficientsOf(PATH, BENT), 1);
    for (let agent = 0; agent < 3; agent += 1) {
      expect(first[2 * agent]).toBeCloseTo(7 / 3, 12);
      expect(first[2 * agent + 1]).toBeCloseTo(1 / 3, 12);
    }
  });

  test("every mode more brings the formation nearer", () => {
    const coefficients = coefficientsOf(PATH, BENT);
    const errors = [1, 2, 3].map((count) => rmsError(partialFormation(PATH, coefficients, count), BENT));
    expect(errors).toEqual([...errors].sort((a, b) => b - a));
  });
});

describe("the cut of a mode", () => {
  test("an agent where the mode is zero is on neither side, and no tie to it is cut", () => {
    const sides = sidesOf(Float64Array.of(HALF, 1e-17, -HALF));
    expect([...sides]).toEqual([1, 0, -1]);
    expect([...cutPairs(Uint32Array.of(0, 1, 1, 2), sides)]).toEqual([]);
    expect([...cutPairs(Uint32Array.of(0, 2), sides)]).toEqual([0, 2]);
  });

  test("ties of some agents are those between them, by their place among them", () => {
    expect([...pairsAmong([1, 4, 6], Uint32Array.of(0, 1, 1, 4, 4, 6, 5, 6))]).toEqual([0, 1, 1, 2]);
  });

  test("the line runs through a triangle where the entries would be zero", () => {
    const corner = Formation.from([
      [0, 0],
      [4, 0],
      [0, 4],
    ]);
    const line = cutLine(Float64Array.of(1, -1, -3), corner, Uint32Array.of(0, 1, 2));
    expect([...line]).toEqual([2, 0, 0, 1]);
  });

  test("a triangle on one side has no line", () => {
    expect(cutLine(Float64Array.of(1, 2, 3), BENT, Uint32Array.of(0, 1, 2))).toHaveLength(0);
  });
});

test("a match reads its rows and the pairing of every order", () => {
  const rows = [0.1, 0.9, 0.8, 0.2];
  const pairings = MATCH_ORDERS.flatMap((_, order) => (order === 0 ? [0, 1] : [1, 0]));
  const match = new ModeMatch(2, Float32Array.from([...rows, ...pairings]));
  expect(match.shownCount).toBe(2);
  expect(match.amount(0, 1)).toBeCloseTo(0.9);
  expect([...match.targets(0)]).toEqual([0, 1]);
  expect([...match.targets(3)]).toEqual([1, 0]);
});

test("likeness along a pairing is its mean and its least", () => {
  expect(likenessAlong([1, 0.5])).toEqual({ mean: 0.75, least: 0.5 });
  expect(likenessAlong([]).least).toBe(1);
});
