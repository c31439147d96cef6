import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { type Camera, toScreen } from "./camera";
import { agentAt, agentReach, agentsWithin, tieAt } from "./hit";

const camera: Camera = { scale: 10, left: 200, top: 200 };

describe("hit test", () => {
  it("of agents within reach the nearest is meant", () => {
    const coordinate = fc.integer({ min: -20, max: 20 });
    const places = fc.array(fc.tuple(coordinate, coordinate), { minLength: 1, maxLength: 30 });
    fc.assert(
      fc.property(places, coordinate, coordinate, (agents, x, y) => {
        const at = toScreen(camera, [x, y]);
        const found = agentAt(agents.flat(), camera, at, 30);
        const distances = agents.map(([a, b]) => 10 * Math.hypot(a - x, b - y));
        const nearest = Math.min(...distances);
        if (found === null) expect(nearest).toBeGreaterThan(30);
        else expect(distances[found]).toBeCloseTo(nearest, 9);
      }),
    );
  });

  it("of two on one spot the one on top is meant", () => {
    expect(agentAt([1, 1, 1, 1], camera, toScreen(camera, [1, 1]), 5)).toBe(1);
  });

  it("a fingertip reaches 22 px however small the disc", () => {
    expect(agentReach(2, "touch")).toBe(22);
    expect(agentReach(2, "mouse")).toBeLessThan(10);
  });

  it("a tie is hit along its line and not beyond its ends", () => {
    const xy = [0, 0, 10, 0, 10, 10];
    const pairs = Uint32Array.from([0, 1, 1, 2]);
    expect(tieAt(pairs, xy, camera, toScreen(camera, [5, 0.2]), 5)).toBe(0);
    expect(tieAt(pairs, xy, camera, toScreen(camera, [10.2, 7]), 5)).toBe(1);
    expect(tieAt(pairs, xy, camera, toScreen(camera, [-1, 0]), 5)).toBeNull();
    expect(tieAt(pairs, xy, camera, toScreen(camera, [5, 1]), 5)).toBeNull();
  });

  it("a tie between agents on one spot can still be hit", () => {
    expect(tieAt([0, 1], [3, 3, 3, 3], camera, toScreen(camera, [3, 3]), 5)).toBe(0);
  });

  it("a rectangle holds the agents inside it, whichever corner it was drawn from", () => {
    const xy = [0, 0, 5, 5, 9, 1, Number.NaN, 0];
    expect(agentsWithin(xy, [6, 6], [-1, -1])).toEqual([0, 1]);
    expect(agentsWithin(xy, [5, 5], [5, 5])).toEqual([1]);
  });
});
