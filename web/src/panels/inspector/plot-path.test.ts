import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { areaPath, belowPath, curvePath, type PlotFrame, plotY } from "./plot-path";

const frame: PlotFrame = { width: 100, height: 20, low: 0, high: 10 };

function points(path: string): number[][] {
  return [...path.matchAll(/[ML](-?[\d.]+) (-?[\d.]+)/g)].map(([, x, y]) => [Number(x), Number(y)]);
}

describe("a curve", () => {
  test("runs from edge to edge, low values at the bottom", () => {
    expect(points(curvePath([0, 10, 5], frame))).toEqual([
      [0, 20],
      [50, 0],
      [100, 10],
    ]);
  });

  test("stays inside the plot whatever its values", () => {
    fc.assert(
      fc.property(fc.array(fc.double({ min: -1e6, max: 1e6, noNaN: true }), { maxLength: 500 }), (values) => {
        for (const [x = -1, y = -1] of points(curvePath(values, frame))) {
          expect(x).toBeGreaterThanOrEqual(0);
          expect(x).toBeLessThanOrEqual(100);
          expect(y).toBeGreaterThanOrEqual(0);
          expect(y).toBeLessThanOrEqual(20);
        }
      }),
    );
  });

  test("of ten thousand samples draws at most two points a pixel and keeps a lone spike", () => {
    const values = Array.from({ length: 10_000 }, (_, index) => (index === 4321 ? 10 : 1));
    const drawn = points(curvePath(values, frame));
    expect(drawn.length).toBeLessThanOrEqual(200);
    expect(Math.min(...drawn.map(([, y = 20]) => y))).toBe(plotY(frame, 10));
  });

  test("without a sample draws nothing", () => {
    expect(curvePath([], frame)).toBe("");
    expect(areaPath([], frame)).toBe("");
  });
});

describe("the part below a limit", () => {
  test("begins and ends where the curve crosses the limit", () => {
    const path = belowPath([8, 2, 8], frame, 5);
    expect(points(path)).toEqual([
      [25, 10],
      [50, 16],
      [75, 10],
    ]);
  });

  test("is open at an end that lies below", () => {
    expect(points(belowPath([2, 2], frame, 5))[0]).toEqual([0, 16]);
  });

  test("is nothing for a curve that keeps above", () => {
    expect(belowPath([5, 6, 7], frame, 5)).toBe("");
  });

  test("has as many strokes as the curve dives", () => {
    expect(belowPath([8, 2, 8, 2, 8], frame, 5).match(/M/g)).toHaveLength(2);
  });
});
