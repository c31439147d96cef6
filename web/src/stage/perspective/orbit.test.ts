import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { between, nearer, type Orbit, type Reach, shortestTurn, slid, turned } from "./orbit";
import { Sight } from "./sight";

const REACH: Reach = { bounds: { minX: -50, maxX: 50, minY: -30, maxY: 30 }, nearest: 5, farthest: 400 };
const FRONT: Orbit = { x: 0, y: 0, z: 0, distance: 80, azimuth: 0, elevation: 0.6 };
const SIZE = { width: 1100, height: 660 };

const orbits = fc.record({
  x: fc.double({ min: -20, max: 20, noNaN: true }),
  y: fc.double({ min: -20, max: 20, noNaN: true }),
  z: fc.constant(0),
  distance: fc.double({ min: 20, max: 200, noNaN: true }),
  azimuth: fc.double({ min: -7, max: 7, noNaN: true }),
  elevation: fc.double({ min: 0.2, max: 1.5, noNaN: true }),
});

function onScreen(orbit: Orbit, x: number, y: number): Float32Array {
  const sight = new Sight();
  const out = new Float32Array(3);
  sight.look(orbit, SIZE);
  sight.projectInto(x, y, 0, out, 0);
  return out;
}

describe("orbit", () => {
  it("the eye never goes below the ground nor over the top", () => {
    expect(turned(FRONT, 0, -9).elevation).toBeGreaterThan(0);
    expect(turned(FRONT, 0, 9).elevation).toBe(Math.PI / 2);
  });

  it("what the pointer is on stays under it while zooming", () => {
    fc.assert(
      fc.property(orbits, fc.double({ min: 0.7, max: 1.4, noNaN: true }), (orbit, factor) => {
        const [x, y] = [orbit.x + 3, orbit.y - 2];
        const before = onScreen(orbit, x, y);
        const after = onScreen(nearer(orbit, factor, [x, y], REACH), x, y);
        // Single precision of a screen coordinate, a few roundings of it.
        expect(Math.hypot((after[0] ?? 0) - (before[0] ?? 0), (after[1] ?? 0) - (before[1] ?? 0))).toBeLessThan(0.01);
      }),
    );
  });

  it("nobody gets lost: the target stays on the stage and the eye within reach of it", () => {
    expect(slid(FRONT, 1e6, -1e6, REACH)).toMatchObject({ x: 50, y: -30 });
    expect(nearer(FRONT, 1e9, [0, 0], REACH).distance).toBe(REACH.nearest);
    expect(nearer(FRONT, 1e-9, [0, 0], REACH).distance).toBe(REACH.farthest);
  });

  it("a flight begins and ends exactly, and takes the shorter way around", () => {
    const to: Orbit = { x: 4, y: 5, z: 1, distance: 20, azimuth: 2 * Math.PI - 0.2, elevation: 0.2 };
    expect(between(FRONT, to, 0)).toBe(FRONT);
    expect(between(FRONT, to, 1)).toBe(to);
    const middle = between(FRONT, to, 0.5);
    expect(middle.azimuth).toBeCloseTo(-0.1, 12);
    expect(middle.distance).toBeCloseTo(40, 12);
  });

  it("a turn is never more than half a one", () => {
    fc.assert(
      fc.property(fc.double({ min: -100, max: 100, noNaN: true }), (angle) => {
        const turn = shortestTurn(angle);
        expect(Math.abs(turn)).toBeLessThanOrEqual(Math.PI + 1e-12);
        // Cosines of angles up to 100 keep 13 digits.
        expect(Math.cos(turn)).toBeCloseTo(Math.cos(angle), 10);
      }),
    );
  });
});
