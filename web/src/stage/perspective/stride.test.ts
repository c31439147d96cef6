import { describe, expect, it } from "vitest";
import { SegmentMotion } from "../../playback/motion";
import { Distances, distancesOf, strideCount } from "./stride";

/** One agent around a corner, three meters and four; another that stands. */
const corner = new SegmentMotion(Float64Array.of(0, 1, 3), Float32Array.of(0, 0, 9, 9, 3, 0, 9, 9, 3, 4, 9, 9), 2);

function traveled(distances: Distances, time: number): number[] {
  const out = new Float32Array(2);
  distances.traveledInto(time, out);
  return [...out];
}

describe("strides", () => {
  it("are measured along the way, not across the corner", () => {
    const distances = new Distances(corner);
    expect([...distances.totals]).toEqual([7, 0]);
    expect(traveled(distances, 1)).toEqual([3, 0]);
    expect(traveled(distances, 2)).toEqual([5, 0]);
    expect(traveled(distances, 99)).toEqual([7, 0]);
  });

  it("a motion is measured once", () => {
    expect(distancesOf(corner)).toBe(distancesOf(corner));
  });

  it("a long motion of a crowd is measured at fewer samples, and still to its end", () => {
    const [samples, agentCount] = [4001, 1000];
    const times = Float64Array.from({ length: samples }, (_, sample) => sample / 30);
    const xy = new Float32Array(samples * agentCount * 2);
    for (let sample = 0; sample < samples; sample += 1) {
      for (let agent = 0; agent < agentCount; agent += 1) xy[2 * (sample * agentCount + agent)] = sample / 100;
    }
    const distances = new Distances(new SegmentMotion(times, xy, agentCount));
    const out = new Float32Array(agentCount);
    distances.traveledInto(2000 / 30, out);
    // Sums of thousands of single-precision steps of 0.01.
    expect(out[7]).toBeCloseTo(20, 2);
    expect(distances.totals[999]).toBeCloseTo(40, 2);
  });

  it("come in whole numbers, as near to the pace as they can, and one at least", () => {
    expect([0, 0.2, 1.4, 2.3, 30].map((total) => strideCount(total, 1.5))).toEqual([1, 1, 1, 2, 20]);
  });
});
