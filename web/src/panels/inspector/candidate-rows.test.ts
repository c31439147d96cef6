import { expect, test } from "vitest";
import type { MethodName } from "../../document/scene";
import type { Candidate } from "../../engine/api";
import { allOfThem, bestOfEach } from "./candidate-rows";

function candidate(method: MethodName, score: number, isChosen = false): Candidate {
  return {
    method,
    order: "greedy",
    alignment: "pca",
    sharing: 0.5,
    distortion: 0,
    turning: 0,
    clearance: null,
    score,
    isChosen,
  };
}

test("each method stands once, by its best candidate, best first", () => {
  const rows = bestOfEach([candidate("linear", 0.9), candidate("spectral", 0.5), candidate("spectral", 0.2)]);
  expect(rows.map((row) => [row.name, row.candidate.score])).toEqual([
    ["Spectral", 0.2],
    ["Linear", 0.9],
  ]);
});

test("the chosen candidate is never left out, even where another of its method scores the same or less", () => {
  const rows = bestOfEach([candidate("spectral", 0.2), candidate("spectral", 0.2, true), candidate("linear", 0.9)]);
  expect(rows[0]?.candidate.isChosen).toBe(true);
});

test("the whole table holds every candidate", () => {
  expect(allOfThem([candidate("linear", 2), candidate("polar", 1)]).map((row) => row.name)).toEqual([
    "Polar",
    "Linear",
  ]);
});
