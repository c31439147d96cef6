import { describe, expect, it } from "vitest";
import { DEFAULT_AGENT, keyframeAt } from "../../document/defaults";
import { Formation, type Point } from "../../document/formation";
import type { Track } from "../../document/scene";
import { bodySizes } from "./sizes";

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

describe("body sizes", () => {
  it("a crowd is as large as people are", () => {
    expect(bodySizes(rows(0.8, 10))).toEqual({ disc: 0.25, figure: 1.75 });
  });

  it("in a wide formation bodies are larger, so that they are seen, but never near each other", () => {
    const { disc, figure } = bodySizes(rows(6, 10));
    expect(disc).toBeGreaterThan(0.25);
    expect(figure).toBeGreaterThan(1.75);
    expect(2 * disc).toBeLessThan(6);
    expect(figure).toBeLessThan(6 * 1.4 + 1e-9);
  });

  it("who has a larger body is drawn larger", () => {
    expect(bodySizes(rows(0.8, 10, 0.5))).toEqual({ disc: 0.5, figure: 3.5 });
  });

  it("one agent and none have a size", () => {
    for (const track of [rows(1, 1), rows(1, 0)]) {
      expect(bodySizes(track)).toEqual({ disc: 0.25, figure: 1.75 });
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
