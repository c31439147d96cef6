import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { keyframeAt } from "../document/defaults";
import { Formation, type Point } from "../document/formation";
import type { Keyframe, Track } from "../document/scene";
import { discRadius, fade, neighborSpacing, screenSpacing, spacingAt, transitionSpacing } from "./spacing";

function keyframe(time: number, hold: number, points: readonly Point[]): Keyframe {
  return { ...keyframeAt(time, Formation.from(points)), hold };
}

function row(count: number, distance: number): Point[] {
  return Array.from({ length: count }, (_, k) => [k * distance, 0]);
}

function track(...keyframes: Keyframe[]): Track {
  return { agents: [], keyframes, segments: [] };
}

describe("spacing", () => {
  it("is the median distance to the nearest neighbor", () => {
    const points = fc.array(
      fc.tuple(fc.double({ min: -50, max: 50, noNaN: true }), fc.double({ min: -50, max: 50, noNaN: true })),
      { minLength: 2, maxLength: 40 },
    );
    fc.assert(
      fc.property(points, (places) => {
        const nearest = places
          .map(([x, y], i) => Math.min(...places.filter((_, j) => j !== i).map(([p, q]) => Math.hypot(p - x, q - y))))
          .filter((distance) => distance > 1e-6)
          .sort((a, b) => a - b);
        const expected = nearest[nearest.length >> 1] ?? Number.POSITIVE_INFINITY;
        const actual = neighborSpacing(Formation.from(places));
        // Squaring and taking the root costs a few last bits.
        if (Number.isFinite(expected)) expect(Math.abs(actual - expected)).toBeLessThanOrEqual(1e-12 * (1 + expected));
        else expect(actual).toBe(expected);
      }),
    );
  });

  it("a lone agent and agents on one spot are drawn at full size", () => {
    for (const places of [[], [[0, 0]], Array.from({ length: 5 }, () => [1, 1])] as Point[][]) {
      expect(discRadius(screenSpacing(neighborSpacing(Formation.from(places)), 10))).toBe(11);
    }
  });

  it("does not change within a transition, and follows the tighter keyframe", () => {
    const scene = track(keyframe(0, 0, row(5, 2)), keyframe(10, 1, row(5, 4)), keyframe(20, 0, row(5, 3)));
    expect(transitionSpacing(scene, 0)).toBe(2);
    expect(transitionSpacing(scene, 1)).toBe(3);
    for (const time of [0, 1, 5, 9.7]) expect(spacingAt(scene, time)).toBe(2);
    for (const time of [11.3, 15, 20, 99]) expect(spacingAt(scene, time)).toBe(3);
  });

  it("changes over from one transition to the next without a jump", () => {
    const scene = track(keyframe(0, 0, row(5, 2)), keyframe(10, 1, row(5, 4)), keyframe(20, 0, row(5, 3)));
    let last = spacingAt(scene, 9);
    for (let time = 9; time < 12; time += 0.01) {
      const now = spacingAt(scene, time);
      expect(now).toBeGreaterThanOrEqual(last);
      // One meter over 1.5 s, at most 1.5 times as steep in the middle of a smoothstep.
      expect(now - last).toBeLessThanOrEqual(1.5 * (0.01 / 1.5) + 1e-9);
      last = now;
    }
  });

  it("one keyframe has its own spacing", () => {
    expect(spacingAt(track(keyframe(0, 0, row(5, 2))), 3)).toBe(2);
  });

  it("details fade, never pop", () => {
    expect(fade(11, 11, 16)).toBe(0);
    expect(fade(16, 11, 16)).toBe(1);
    expect(fade(13.5, 11, 16)).toBeCloseTo(0.5, 12);
  });
});
