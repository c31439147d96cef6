import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { toScreen } from "../camera";
import type { Orbit } from "./orbit";
import { Sight } from "./sight";
import { audienceSeat, type Box, overPlan, overview } from "./viewpoints";

const FIELD: Box = { minX: -30, maxX: 40, minY: -20, maxY: 25, height: 1.75 };
const SIZE = { width: 1096, height: 664 };

const sizes = fc.record({ width: fc.integer({ min: 300, max: 2500 }), height: fc.integer({ min: 300, max: 1500 }) });
const boxes = fc
  .record({
    width: fc.double({ min: 2, max: 200, noNaN: true }),
    depth: fc.double({ min: 2, max: 200, noNaN: true }),
    x: fc.double({ min: -50, max: 50, noNaN: true }),
  })
  .map(({ width, depth, x }) => ({ minX: x, maxX: x + width, minY: -depth / 2, maxY: depth / 2, height: 1.75 }));

function corners(orbit: Orbit, box: Box, size: typeof SIZE): Float32Array[] {
  const sight = new Sight();
  sight.look(orbit, size);
  return [box.minX, box.maxX].flatMap((x) =>
    [box.minY, box.maxY].flatMap((y) =>
      [0, box.height].map((z) => {
        const out = new Float32Array(3);
        sight.projectInto(x, y, z, out, 0);
        return out;
      }),
    ),
  );
}

describe("viewpoints", () => {
  it("the overview has everything on the screen, whatever the stage and the window", () => {
    fc.assert(
      fc.property(boxes, sizes, (box, size) => {
        for (const [x = 0, y = 0, depth = 0] of corners(overview(box, size), box, size)) {
          expect(depth).toBeGreaterThan(0);
          expect(x).toBeGreaterThan(0);
          expect(x).toBeLessThan(size.width);
          expect(y).toBeGreaterThan(0);
          expect(y).toBeLessThan(size.height);
        }
      }),
    );
  });

  it("the overview is no farther than it takes", () => {
    const xs = corners(overview(FIELD, SIZE), FIELD, SIZE).map(([x = 0]) => x);
    expect(Math.max(...xs) - Math.min(...xs)).toBeGreaterThan(0.8 * SIZE.width);
  });

  it("the audience sits in front of the stage, raised, and looks over it", () => {
    fc.assert(
      fc.property(boxes, sizes, (box, size) => {
        const sight = new Sight();
        sight.look(audienceSeat(box, box, size), size);
        const [, y = 0, z = 0] = sight.eye;
        expect(y).toBeLessThan(box.minY);
        expect(z).toBeGreaterThan(0);
        expect(z).toBeLessThan(box.minY - y + (box.maxY - box.minY));
      }),
    );
  });

  it("a flight takes off exactly from where the plan is seen", () => {
    const camera = { scale: 9, left: 500, top: 300 };
    const sight = new Sight();
    sight.look(overPlan(camera, SIZE), SIZE);
    const out = new Float32Array(3);
    for (const point of [
      [0, 0],
      [30, -12],
    ] as const) {
      sight.projectInto(point[0], point[1], 0, out, 0);
      const plan = toScreen(camera, point);
      expect(out[0]).toBeCloseTo(plan.x, 2);
      expect(out[1]).toBeCloseTo(plan.y, 2);
    }
  });
});
