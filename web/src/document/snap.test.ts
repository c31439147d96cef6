import { expect, test } from "vitest";
import { addAgents } from "./commands/agents";
import { emptyScene } from "./defaults";
import type { Point } from "./formation";
import { CENTIMETER, FIELD_GRID, snapApart, snapOf, snapPoint, snapValue } from "./snap";

const STEP = 0.5715;

test("a snapped coordinate is the decimal a person would write", () => {
  expect(snapPoint([0.3499999, -1.00000001], CENTIMETER)).toEqual([0.35, -1]);
  expect(Object.is(snapValue(-0.001, CENTIMETER), 0)).toBe(true);
});

test("snapping twice is snapping once", () => {
  for (const snap of [CENTIMETER, FIELD_GRID]) {
    for (let i = 0; i < 200; i += 1) {
      const once = snapValue(Math.sin(i) * 40, snap);
      expect(snapValue(once, snap)).toBe(once);
    }
  }
});

test("a football field snaps to marching steps, everything else to centimeters", () => {
  const scene = emptyScene();
  expect(snapOf(scene)).toBe(CENTIMETER);
  expect(snapOf({ ...scene, stage: { ...scene.stage, backdrop: "football-college" } })).toBe(FIELD_GRID);
  expect(snapValue(STEP * 7.003, FIELD_GRID)).toBeCloseTo(STEP * 7, 12);
});

test("agents that stand in steps keep to steps on any backdrop", () => {
  const inSteps = [0, 1, 2, 3].map((i): Point => [i * STEP, 2 * STEP]);
  expect(snapOf(addAgents(inSteps).apply(emptyScene()))).toBe(FIELD_GRID);
  const nowhere: Point[] = [[Math.PI, Math.E]];
  expect(snapOf(addAgents(nowhere).apply(emptyScene()))).toBe(CENTIMETER);
});

test("places closer than the lattice stay apart", () => {
  const places: Point[] = [
    [0.001, 0],
    [0.003, 0],
    [0.02, 0],
  ];
  const snapped = snapApart(places, CENTIMETER);
  expect(new Set(snapped.map(String)).size).toBe(3);
  expect(snapped[0]).toEqual([0, 0]);
  expect(snapped[2]).toEqual([0.02, 0]);
});
