import { describe, expect, it } from "vitest";
import type { Units } from "../../document/scene";
import { metersPer } from "../../document/units";
import { gridSteps } from "./grid";

describe("grid", () => {
  it.each<[number, Units, number]>([
    [27.8, "m", 5],
    [10, "m", 5],
    [6, "m", 10],
    [3, "m", 50],
    [100, "m", 1],
    [27.8, "yd", 5],
    [27.8, "ft", 5],
    [27.8, "steps", 4],
    [10, "steps", 8],
  ])("at %d px a meter lines stand every so many %s", (scale, units, count) => {
    expect(gridSteps(scale, units).major / metersPer(units)).toBeCloseTo(count, 9);
  });

  it("lines always leave room for their numbers", () => {
    for (const units of ["m", "ft", "yd", "steps"] as const) {
      for (let scale = 0.002; scale < 4000; scale *= 1.3) {
        expect(gridSteps(scale, units).major * scale).toBeGreaterThanOrEqual(42);
      }
    }
  });
});
