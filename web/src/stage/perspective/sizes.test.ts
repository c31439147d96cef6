import { describe, expect, it } from "vitest";
import { DEFAULT_AGENT, keyframeAt } from "../../document/defaults";
import { Formation, type Point } from "../../document/formation";
import type { Track } from "../../document/scene";
import { bodySizes } from "./sizes";

const TWO_OF_A_HUNDRED = [17, 60];

function rows(spacing: number, across: number, radius = 0.25): Track {
  const points: Point[] = Array.from({ length: across * across }, (_, k) => [
    spacing * (k % across),
    spacing * Math.floor(k / across),
  ]);
  return {
    agents: points.map(() => ({ ...DEFAULT_AGENT, radius })),
    keyframes: [keyframeAt(0, Formation.from(points))],
    segments: [],
  };
}

function withRadii(track: Track, radii: readonly [number, number]): Track {
  const agents = track.agents.map((agent, index) => {
    const radius = radii[TWO_OF_A_HUNDRED.indexOf(index)];
    return radius === undefined ? agent : { ...agent, radius };
  });
  return { ...track, agents };
}

describe("body sizes", () => {
  it("a crowd is as large as people are", () => {
    expect(bodySizes(rows(0.8, 10))).toMatchObject({ disc: 0.25, figure: 1.75 });
  });

  it("in a wide formation bodies are larger, so that they are seen, but never near each other", () => {
    const { disc, figure } = bodySizes(rows(6, 10));
    expect(disc).toBeGreaterThan(0.25);
    expect(figure).toBeGreaterThan(1.75);
    expect(2 * disc).toBeLessThan(6);
    expect(figure).toBeLessThan(6 * 1.4 + 1e-9);
  });

  it("who have a larger body are drawn larger", () => {
    expect(bodySizes(rows(0.8, 10, 0.5))).toMatchObject({ disc: 0.5, figure: 3.5 });
  });

  it("who differs from the others is drawn as much larger or smaller, and they stay as they are", () => {
    const { disc, figure, tallest, shares } = bodySizes(withRadii(rows(0.8, 10), [0.5, 0.125]));
    expect({ disc, figure, tallest }).toEqual({ disc: 0.25, figure: 1.75, tallest: 3.5 });
    expect(TWO_OF_A_HUNDRED.map((agent) => shares[agent])).toEqual([2, 0.5]);
    expect(shares[0]).toBe(1);
  });

  it("where bodies are larger than life, a large one leaves room to its neighbors unless it truly takes it", () => {
    const { disc, shares } = bodySizes(withRadii(rows(6, 10), [1, 5]));
    const [large = 0, huge = 0] = TWO_OF_A_HUNDRED.map((agent) => (shares[agent] ?? 0) * disc);
    expect(large).toBeGreaterThan(disc);
    expect(large).toBeLessThanOrEqual(3 + 1e-6);
    expect(huge).toBeCloseTo(5, 5);
  });

  it("one agent and none have a size", () => {
    for (const track of [rows(1, 1), rows(1, 0)]) {
      expect(bodySizes(track)).toMatchObject({ disc: 0.25, figure: 1.75, tallest: 1.75 });
    }
  });

  it("who flies is seen from farther away, and drawn larger", () => {
    const flat = rows(6, 10);
    const lifted = flat.keyframes.map((frame) => ({
      ...frame,
      positions: new Formation(frame.positions.xy, new Float64Array(100)),
    }));
    expect(bodySizes({ ...flat, keyframes: lifted }).disc).toBeGreaterThan(bodySizes(flat).disc);
  });
});
