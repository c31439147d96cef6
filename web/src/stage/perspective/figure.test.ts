import { describe, expect, it } from "vitest";
import { figureShape, HEIGHTS, LIMB } from "./figure";

const { corners, parts, triangles } = figureShape(4);
const corner = (index: number) => [...corners.subarray(3 * index, 3 * index + 3)];
const indices = [...Array(corners.length / 3).keys()];

/** By corner: the first corner of its limb. Corners of a limb are listed together, and triangles join them. */
const limbs = (() => {
  const farthest = new Map<number, number>();
  for (let k = 0; k < triangles.length; k += 3) {
    const ends = [...triangles.subarray(k, k + 3)];
    const first = Math.min(...ends);
    farthest.set(first, Math.max(farthest.get(first) ?? 0, ...ends));
  }
  let [start, reached] = [0, 0];
  return indices.map((index) => {
    if (index > reached) start = index;
    reached = Math.max(reached, index, farthest.get(index) ?? 0);
    return start;
  });
})();

function middleOfLimb(index: number): number[] {
  const limb = indices.filter((other) => limbs[other] === limbs[index]);
  return [0, 1, 2].map((axis) => limb.reduce((sum, other) => sum + (corner(other)[axis] ?? 0), 0) / limb.length);
}

describe("the walking figure", () => {
  it("stands on the ground and is one high", () => {
    const heights = indices.map((index) => corner(index)[2] ?? 0);
    expect(Math.min(...heights)).toBe(0);
    expect(Math.max(...heights)).toBe(1);
  });

  it("its right is the mirror of its left", () => {
    const side = (limb: number) => indices.filter((index) => parts[2 * index] === limb).map(corner);
    for (const [left, right] of [
      [LIMB.leftLeg, LIMB.rightLeg],
      [LIMB.leftArm, LIMB.rightArm],
    ] as const) {
      const mirrored = side(left).map(([x = 0, y = 0, z = 0]) => [x, -y, z]);
      for (const place of side(right)) {
        const near = mirrored.some(
          (other) => Math.hypot(...place.map((value, axis) => value - (other[axis] ?? 0))) < 1e-6,
        );
        expect(near).toBe(true);
      }
    }
  });

  it("is closed toward the eye: every triangle faces outward from its limb", () => {
    for (let k = 0; k < triangles.length; k += 3) {
      const [a, b, c] = [0, 1, 2].map((n) => corner(triangles[k + n] ?? 0)) as [number[], number[], number[]];
      const middle = middleOfLimb(triangles[k] ?? 0);
      const [ux, uy, uz] = [0, 1, 2].map((n) => (b[n] ?? 0) - (a[n] ?? 0)) as [number, number, number];
      const [vx, vy, vz] = [0, 1, 2].map((n) => (c[n] ?? 0) - (a[n] ?? 0)) as [number, number, number];
      const normal = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
      const outward = normal.reduce((sum, n, axis) => {
        const center = ((a[axis] ?? 0) + (b[axis] ?? 0) + (c[axis] ?? 0)) / 3;
        return sum + n * (center - (middle[axis] ?? 0));
      }, 0);
      expect(outward).toBeGreaterThan(0);
    }
  });

  it("limbs reach their joints, so that bending leaves no hole", () => {
    const span = (limb: number, below: 0 | 1) => {
      const own = indices.filter((index) => parts[2 * index] === limb && parts[2 * index + 1] === below);
      const heights = own.map((index) => corner(index)[2] ?? 0);
      return [Math.min(...heights), Math.max(...heights)] as const;
    };
    expect(span(LIMB.leftLeg, 0)[0]).toBeLessThan(HEIGHTS.knee);
    expect(span(LIMB.leftLeg, 1)[1]).toBeGreaterThan(HEIGHTS.knee);
    expect(span(LIMB.leftLeg, 0)[1]).toBeGreaterThan(HEIGHTS.hip);
    expect(span(LIMB.leftArm, 0)[0]).toBeLessThan(HEIGHTS.elbow);
    expect(span(LIMB.leftArm, 1)[1]).toBeGreaterThan(HEIGHTS.elbow);
  });

  it("a crowd of 1,260 is under half a million triangles", () => {
    expect((triangles.length / 3) * 1260).toBeLessThan(500_000);
  });
});
