import { expect, test } from "vitest";
import { numbersOf } from "./example-numbers";
import type { Preview } from "./services";

const PREVIEW: Preview = {
  agentCount: 2,
  sampleCount: 2,
  duration: 1,
  xy: new Float32Array(8),
  colors: [],
  leastDistances: [0.031, 2, 1.208],
  distortions: [0.48, 0.06, 0.051],
};

test("a show says how near anybody comes in any transition, and what distortion is on average", () => {
  expect(numbersOf(PREVIEW, undefined)).toBe("Nearest 0.03 m; distortion 0.20");
});

test("two ways side by side say both of theirs", () => {
  expect(numbersOf(PREVIEW, { kind: "compare", segments: [0, 2] })).toBe(
    "Nearest 0.03, then 1.21 m; distortion 0.48, then 0.05",
  );
});

test("three ways say each of theirs, and what is tried otherwise says those of the show", () => {
  expect(numbersOf(PREVIEW, { kind: "compare", segments: [0, 1, 2] })).toBe(
    "Nearest 0.03, then 2.00, then 1.21 m; distortion 0.48, then 0.06, then 0.05",
  );
  expect(numbersOf(PREVIEW, { kind: "compare", segments: [0, 0], preset: "others" })).toBe(
    numbersOf(PREVIEW, undefined),
  );
});

test("what has no motion yet has no numbers", () => {
  expect(numbersOf({ ...PREVIEW, leastDistances: [], distortions: [] }, { kind: "recording" })).toBe("");
});
