import { describe, expect, it } from "vitest";
import type { Orbit } from "./orbit";
import { Sight } from "./sight";

const SIZE = { width: 1000, height: 600 };
const FROM_THE_RIGHT: Orbit = { x: 2, y: 3, z: 0, distance: 50, azimuth: Math.PI / 2, elevation: 0.5 };

function seen(orbit: Orbit): { sight: Sight; at(x: number, y: number, z: number): number[] } {
  const sight = new Sight();
  sight.look(orbit, SIZE);
  const out = new Float32Array(3);
  return {
    sight,
    at(x, y, z) {
      sight.projectInto(x, y, z, out, 0);
      return [...out];
    },
  };
}

describe("sight", () => {
  it("what is looked at is in the middle, its distance away", () => {
    const [x, y, depth] = seen(FROM_THE_RIGHT).at(2, 3, 0);
    expect([x, y]).toEqual([500, 300]);
    expect(depth).toBeCloseTo(50, 4);
  });

  it("from the front, right is right, up is up and the back row is smaller and higher", () => {
    const { at } = seen({ ...FROM_THE_RIGHT, azimuth: 0 });
    expect(at(3, 3, 0)[0]).toBeGreaterThan(500);
    expect(at(2, 3, 1)[1]).toBeLessThan(300);
    const [near, far] = [at(3, -7, 0), at(3, 13, 0)];
    expect(far[1]).toBeLessThan(near[1] ?? 0);
    expect((far[0] ?? 0) - 500).toBeLessThan((near[0] ?? 0) - 500);
  });

  it("from the audience's right, the stage's depth runs to the right", () => {
    expect(seen(FROM_THE_RIGHT).at(2, 4, 0)[0]).toBeGreaterThan(500);
  });

  it("the ground under a place of the screen is what is seen there", () => {
    const { sight, at } = seen(FROM_THE_RIGHT);
    for (const [x, y] of [
      [2, 3],
      [-9, 7],
      [14, -12],
    ] as const) {
      const [screenX = 0, screenY = 0] = at(x, y, 0);
      const ground = sight.groundAt({ x: screenX, y: screenY });
      expect(ground?.[0]).toBeCloseTo(x, 3);
      expect(ground?.[1]).toBeCloseTo(y, 3);
    }
  });

  it("there is no ground above the horizon", () => {
    const low = seen({ ...FROM_THE_RIGHT, elevation: 0.06 });
    expect(low.sight.groundAt({ x: 500, y: 10 })).toBeNull();
  });

  it("what is behind the eye is nowhere", () => {
    expect(seen({ ...FROM_THE_RIGHT, azimuth: 0 }).at(2, -200, 0)[2]).toBe(0);
  });

  it("straight down, the stage lies as on the plan", () => {
    const { at } = seen({ ...FROM_THE_RIGHT, azimuth: 0, elevation: Math.PI / 2 });
    const [right, away] = [at(12, 3, 0), at(2, 13, 0)];
    expect(right[1]).toBeCloseTo(300, 3);
    expect(away[0]).toBeCloseTo(500, 3);
    expect((right[0] ?? 0) - 500).toBeCloseTo(300 - (away[1] ?? 0), 3);
  });
});
