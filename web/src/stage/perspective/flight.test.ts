import { expect, it } from "vitest";
import { FLIGHT } from "./flight";
import type { Orbit } from "./orbit";

const HERE: Orbit = { x: 0, y: 0, z: 0, distance: 100, azimuth: 0, elevation: 1 };
const SEAT: Orbit = { x: 1, y: 2, z: 0, distance: 40, azimuth: 0.4, elevation: 0.2 };

it("an eye takes off and lands softly, and arrives exactly", () => {
  const heights = Array.from({ length: 11 }, (_, k) => FLIGHT.at(HERE, SEAT, k / 10).elevation);
  const steps = heights.slice(1).map((height, k) => (heights[k] ?? 0) - height);
  expect(Math.min(...steps)).toBeGreaterThan(0);
  expect(steps[0]).toBeLessThan((steps[4] ?? 0) / 3);
  expect(steps[9]).toBeLessThan((steps[5] ?? 0) / 3);
  expect(FLIGHT.at(HERE, SEAT, 1)).toBe(SEAT);
});
