import { expect, test } from "vitest";
import type { Box } from "../document/box";
import type { Point } from "../document/formation";
import { guideMove } from "./guides";

const one = (x: number, y: number): Box => ({ min: [x, y], max: [x, y] });

test("one agent is held in line with another, across and along", () => {
  const guided = guideMove(one(0, 0), [[5, 7]], [4.9, 3], 0.2);
  expect(guided.by).toEqual([5, 3]);
  expect(guided.isHeld).toEqual([true, false]);
  expect(guided.guides).toEqual([{ from: [5, 3], to: [5, 7], gap: null }]);
});

test("out of reach nothing holds", () => {
  expect(guideMove(one(0, 0), [[5, 7]], [4.7, 3], 0.2)).toEqual({ by: [4.7, 3], isHeld: [false, false], guides: [] });
});

test("a box is held by its edges and its middle", () => {
  const box: Box = { min: [0, 0], max: [2, 2] };
  expect(guideMove(box, [[10, 30]], [9.95, 5], 0.1).by[0]).toBe(10);
  expect(guideMove(box, [[10, 30]], [9.05, 5], 0.1).by[0]).toBe(9);
  expect(guideMove(box, [[10, 30]], [8.05, 5], 0.1).by[0]).toBe(8);
});

test("in a row, the gap beside is repeated and written on both", () => {
  const row: readonly Point[] = [
    [0, 0],
    [3, 0],
  ];
  const guided = guideMove(one(10, 5), row, [-4.08, -5.05], 0.2);
  expect(guided.by).toEqual([-4, -5]);
  const gaps = guided.guides.filter((guide) => guide.gap !== null);
  expect(gaps.map((guide) => guide.gap)).toEqual([3, 3]);
});

test("between two, both gaps are halves of the room", () => {
  const row: readonly Point[] = [
    [0, 0],
    [8, 0],
  ];
  const guided = guideMove(one(0, 5), row, [4.1, -5], 0.2);
  expect(guided.by).toEqual([4, -5]);
  expect(guided.guides.filter((guide) => guide.gap !== null).map((guide) => guide.gap)).toEqual([4, 4]);
});

test("only near neighbors attract", () => {
  const near = Array.from({ length: 12 }, (_, i): Point => [20 + i * 0.01, 20]);
  const far: Point = [400, 3.05];
  expect(guideMove(one(0, 0), [...near, far], [3, 3], 0.2).isHeld).toEqual([false, false]);
  expect(guideMove(one(0, 0), [far], [3, 3], 0.2).isHeld).toEqual([false, true]);
});
