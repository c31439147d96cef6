import fc from "fast-check";
import { describe, expect, it } from "vitest";
import {
  type Bounds,
  between,
  boundsOf,
  type Camera,
  fitting,
  keptInSight,
  recentered,
  SCALE_LIMITS,
  toScreen,
  toStage,
  zoomedAt,
} from "./camera";

const cameras = fc.record({
  scale: fc.double({ min: 0.01, max: 1000, noNaN: true }),
  left: fc.double({ min: -2000, max: 2000, noNaN: true }),
  top: fc.double({ min: -2000, max: 2000, noNaN: true }),
});
const places = fc.record({
  x: fc.double({ min: 0, max: 2000, noNaN: true }),
  y: fc.double({ min: 0, max: 2000, noNaN: true }),
});

// Screen coordinates stay below 1e4 px and pass through a handful of roundings: 1e-9 px is generous and invisible.
const PIXEL_TOLERANCE = 1e-9;

describe("camera", () => {
  it("a place on the screen goes to the stage and back", () => {
    fc.assert(
      fc.property(cameras, places, (camera, at) => {
        const back = toScreen(camera, toStage(camera, at));
        expect(Math.abs(back.x - at.x)).toBeLessThan(PIXEL_TOLERANCE);
        expect(Math.abs(back.y - at.y)).toBeLessThan(PIXEL_TOLERANCE);
      }),
    );
  });

  it("away from the audience is up on the screen", () => {
    const camera: Camera = { scale: 10, left: 100, top: 100 };
    expect(toScreen(camera, [1, 2])).toEqual({ x: 110, y: 80 });
  });

  it("zooming keeps what is under the pointer under the pointer", () => {
    fc.assert(
      fc.property(cameras, places, fc.double({ min: 0.01, max: 100, noNaN: true }), (camera, at, factor) => {
        const kept = toScreen(zoomedAt(camera, factor, at), toStage(camera, at));
        // The stage coordinate reaches 2e5 m at the smallest scale, and zooming multiplies its rounding by the factor.
        expect(Math.hypot(kept.x - at.x, kept.y - at.y)).toBeLessThan(1e-6);
      }),
    );
  });

  it("zooming stops at the limits without moving the stage", () => {
    const closest: Camera = { scale: SCALE_LIMITS.max, left: 7, top: 9 };
    expect(zoomedAt(closest, 10, { x: 300, y: 200 })).toEqual(closest);
  });

  it("fitting shows all of it inside the padding, touching in one direction", () => {
    const bounds: Bounds = { minX: -15, maxX: 15, minY: -10, maxY: 10 };
    const padding = { left: 72, right: 24, top: 60, bottom: 72 };
    const camera = fitting(bounds, { width: 1137, height: 689 }, padding);
    const upperLeft = toScreen(camera, [bounds.minX, bounds.maxY]);
    const lowerRight = toScreen(camera, [bounds.maxX, bounds.minY]);
    expect(upperLeft.y).toBeCloseTo(60, 9);
    expect(lowerRight.y).toBeCloseTo(689 - 72, 9);
    expect(upperLeft.x - 72).toBeCloseTo(1137 - 24 - lowerRight.x, 9);
  });

  it("fitting a single point or an element without room gives a finite camera", () => {
    for (const size of [
      { width: 800, height: 600 },
      { width: 0, height: 0 },
    ]) {
      const camera = fitting({ minX: 3, maxX: 3, minY: 4, maxY: 4 }, size, { left: 9, right: 9, top: 9, bottom: 9 });
      expect(Object.values(camera).every(Number.isFinite)).toBe(true);
    }
  });

  it("panning away leaves a margin of the stage in sight", () => {
    const bounds: Bounds = { minX: -5, maxX: 5, minY: -5, maxY: 5 };
    const lost = keptInSight({ scale: 10, left: 5000, top: -5000 }, bounds, { width: 800, height: 600 }, 40);
    expect(toScreen(lost, [-5, -5])).toEqual({ x: 760, y: 40 });
    const seen: Camera = { scale: 10, left: 400, top: 300 };
    expect(keptInSight(seen, bounds, { width: 800, height: 600 }, 40)).toBe(seen);
  });

  it("a resized element keeps the middle in the middle", () => {
    const camera: Camera = { scale: 10, left: 100, top: 50 };
    const middle = toStage(camera, { x: 400, y: 300 });
    const after = recentered(camera, { width: 800, height: 600 }, { width: 1000, height: 500 });
    expect(toScreen(after, middle)).toEqual({ x: 500, y: 250 });
  });

  it("gliding starts and ends exactly, and the fixed point of a zoom stays fixed", () => {
    const from: Camera = { scale: 10, left: 100, top: 50 };
    const at = { x: 320, y: 240 };
    const to = zoomedAt(from, 8, at);
    expect(between(from, to, 0)).toBe(from);
    expect(between(from, to, 1)).toBe(to);
    const midway = toScreen(between(from, to, 0.4), toStage(from, at));
    expect(midway.x).toBeCloseTo(at.x, 9);
    expect(midway.y).toBeCloseTo(at.y, 9);
  });

  it("the bounds of nothing are nothing", () => {
    expect(boundsOf([])).toBeNull();
    expect(boundsOf([1, 2, -3, 4])).toEqual({ minX: -3, maxX: 1, minY: 2, maxY: 4 });
  });
});
