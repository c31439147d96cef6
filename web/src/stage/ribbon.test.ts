import { describe, expect, it } from "vitest";
import { outlineInto, trailAlphaAt, trailLook } from "./ribbon";

const HEAD = 0.62;

describe("trail", () => {
  it("only ever gets firmer and wider toward the present", () => {
    let last = 0;
    for (let t = 0; t <= 1; t += 0.01) {
      const alpha = trailAlphaAt(t, HEAD);
      expect(alpha).toBeGreaterThan(last);
      last = alpha;
    }
    expect(trailAlphaAt(1, HEAD)).toBeCloseTo(HEAD, 12);
    const look = trailLook(20, 6.2, HEAD, 200);
    expect(look.headWidth).toBeGreaterThan(look.tailWidth);
  });

  it("layered steps add up to the alpha that steps end to end have", () => {
    const layered = trailLook(70, 11, HEAD, 25);
    expect(layered.isLayered).toBe(true);
    let seen = 0;
    for (let step = 0; step < layered.steps; step += 1) {
      seen = 1 - (1 - seen) * (1 - (layered.alphas[step] ?? 0));
      expect(seen).toBeCloseTo(trailAlphaAt((step + 0.5) / layered.steps, layered.headAlpha), 12);
    }
  });

  it("reaches back half the transition and fainter in a crowd, all of it where there is room, without a jump", () => {
    expect(trailLook(11, 3.4, HEAD, 1260).reach).toBe(0.5);
    expect(trailLook(11, 3.4, HEAD, 1260).headAlpha).toBeCloseTo(0.62 * HEAD, 12);
    expect(trailLook(18, 5.6, HEAD, 200).reach).toBe(1);
    expect(trailLook(13, 4, HEAD, 300).reach).toBeCloseTo(0.75, 12);
  });

  it("a ribbon is as wide as it should be, square to its line", () => {
    const out = new Float32Array(12);
    outlineInto(Float32Array.of(0, 0, 10, 0, 20, 0), 3, 2, 6, out, 0);
    expect([...out]).toEqual([0, 1, 0, -1, 10, 2, 10, -2, 20, 3, 20, -3]);
  });

  it("agents that pause keep the direction they had", () => {
    const out = new Float32Array(16);
    outlineInto(Float32Array.of(0, 0, 5, 0, 5, 0, 5, 0), 4, 2, 2, out, 0);
    expect([...out].every(Number.isFinite)).toBe(true);
    expect([...out.subarray(12)]).toEqual([5, 1, 5, -1]);
  });
});
