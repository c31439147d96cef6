import { describe, expect, it } from "vitest";
import { Formation } from "../document/formation";
import type { TieList } from "../engine/api";
import { bundleTies, pairsWithin, shownWeight, tieAlpha, tieStrength, tieWidth, trianglesOf } from "./ties";

const row = Formation.from([
  [0, 0],
  [1, 0],
  [2, 0],
  [3, 0],
]);

function list(...ties: [number, number, number][]): TieList {
  return {
    pairs: Uint32Array.from(ties.flatMap((tie) => tie.slice(0, 2))),
    factors: Float64Array.from(ties.map(([, , factor]) => factor)),
  };
}

describe("ties", () => {
  it.each([
    [1, 0.83, 0.13],
    [10, 1.83, 0.31],
    [100, 3.2, 0.62],
  ])("a tie ×%d looks its weight", (weight, width, alpha) => {
    expect(tieWidth(tieStrength(weight))).toBeCloseTo(width, 2);
    expect(tieAlpha(tieStrength(weight))).toBeCloseTo(alpha, 2);
  });

  it("a proposed tie fades with its length, a tie by hand does not", () => {
    expect(shownWeight(1, 1, 1)).toBe(1);
    expect(shownWeight(1, 2.5, 1)).toBeCloseTo(0.5, 12);
    expect(shownWeight(1, 99, 1)).toBe(0.1);
    expect(shownWeight(10, 99, 1)).toBe(10);
    expect(shownWeight(1, 0, 1)).toBe(1);
  });

  it("a transition shows ties of both ends throughout and the others toward their own end", () => {
    const bundles = bundleTies(
      { ties: list([0, 1, 1], [1, 2, 1]), formation: row },
      { ties: list([1, 2, 1], [2, 3, 1]), formation: row },
      1,
    );
    const pairs = Object.fromEntries(bundles.map((bundle) => [bundle.phase, [...bundle.pairs]]));
    expect(pairs).toEqual({ both: [1, 2], leaving: [0, 1], coming: [2, 3] });
  });

  it("every tie is drawn once", () => {
    const ties = list([0, 1, 1], [1, 2, 10], [2, 3, 100], [0, 3, 0.1]);
    const bundles = bundleTies({ ties, formation: row }, null, 1);
    expect(bundles.reduce((sum, bundle) => sum + bundle.pairs.length / 2, 0)).toBe(4);
    expect(bundles.every((bundle) => bundle.phase === "both")).toBe(true);
  });

  it("a tie of an agent that is gone is left out", () => {
    expect(bundleTies({ ties: list([0, 9, 1]), formation: row }, null, 1)).toEqual([]);
  });

  it("a hull reaches over ties within its group only", () => {
    const bundles = bundleTies({ ties: list([0, 1, 1], [1, 2, 10], [2, 3, 1]), formation: row }, null, 1);
    const pairs = pairsWithin(bundles, Uint32Array.of(0, 1, 2));
    expect(pairs.length).toBe(4);
    expect([...pairs]).not.toContain(3);
  });

  it("three agents all tied to each other are one triangle, in whatever order their ties come", () => {
    expect([...trianglesOf(Uint32Array.of(2, 1, 0, 2, 1, 0))].sort()).toEqual([0, 1, 2]);
    expect(trianglesOf(Uint32Array.of(0, 1, 1, 2, 2, 3, 3, 0))).toHaveLength(0);
    // Four agents all tied have four triangles.
    expect(trianglesOf(Uint32Array.of(0, 1, 0, 2, 0, 3, 1, 2, 1, 3, 2, 3))).toHaveLength(12);
  });
});
