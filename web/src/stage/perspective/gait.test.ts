import { describe, expect, it } from "vitest";
import { HEIGHTS } from "./figure";
import { gaitsInto, type Limbs } from "./gait";

const REACH = 0.21;

function limbsAt(phase: number, reach = REACH): Limbs {
  const limbs: Limbs = {
    leftLeg: new Float32Array(4),
    rightLeg: new Float32Array(4),
    leftArm: new Float32Array(4),
    rightArm: new Float32Array(4),
    posture: new Float32Array(3),
  };
  gaitsInto(Float64Array.of(phase), Float64Array.of(reach), limbs);
  return limbs;
}

/** Where the middle of the sole is: forward of the hip, and above the ground; heights. */
function sole(leg: Float32Array, posture: Float32Array): readonly [forward: number, above: number] {
  const [upperCos = 0, upperSin = 0, lowerCos = 0, lowerSin = 0] = leg;
  const [thigh, shin] = [HEIGHTS.hip - HEIGHTS.knee, HEIGHTS.knee];
  return [thigh * upperSin + shin * lowerSin, HEIGHTS.hip - (posture[0] ?? 0) - thigh * upperCos - shin * lowerCos];
}

describe("the gait", () => {
  it("a foot on the ground neither slides nor sinks while the body goes on", () => {
    const places: number[] = [];
    // The left foot stands from a quarter of a stride before the phase is whole to a quarter after.
    for (let phase = -0.25; phase < 0.2499; phase += 0.01) {
      const limbs = limbsAt(phase);
      const [forward, above] = sole(limbs.leftLeg, limbs.posture);
      places.push(4 * REACH * phase + forward);
      // Cosines and sines are kept in single precision.
      expect(Math.abs(above)).toBeLessThan(1e-6);
    }
    expect(Math.max(...places) - Math.min(...places)).toBeLessThan(1e-6);
  });

  it("the other foot meanwhile swings through above it, and lands a step ahead", () => {
    for (let phase = -0.24; phase < 0.24; phase += 0.02) {
      const limbs = limbsAt(phase);
      expect(sole(limbs.rightLeg, limbs.posture)[1]).toBeGreaterThan(-0.002);
    }
    const [start, end] = [limbsAt(-0.25), limbsAt(0.2499)];
    const step = (limbs: Limbs, phase: number) => 4 * REACH * phase + sole(limbs.rightLeg, limbs.posture)[0];
    expect(step(end, 0.25) - step(start, -0.25)).toBeCloseTo(4 * REACH, 2);
  });

  it("half a stride later left is right", () => {
    const [now, later] = [limbsAt(0.1), limbsAt(0.6)];
    for (let k = 0; k < 4; k += 1) {
      expect(later.rightLeg[k]).toBeCloseTo(now.leftLeg[k] ?? 0, 6);
      expect(later.rightArm[k]).toBeCloseTo(now.leftArm[k] ?? 0, 6);
    }
  });

  it("an arm swings against the leg of its side", () => {
    const { leftLeg, leftArm } = limbsAt(0.2);
    expect(Math.sign(leftLeg[1] ?? 0)).toBe(-Math.sign(leftArm[1] ?? 0));
  });

  it("who does not reach stands straight, at any phase", () => {
    const [one, other] = [limbsAt(0, 0), limbsAt(0.37, 0)];
    for (const limbs of [one, other]) {
      expect([...limbs.leftLeg]).toEqual([1, 0, 1, 0]);
      expect(limbs.posture[0]).toBe(0);
    }
    expect(other.leftArm).toEqual(one.leftArm);
  });
});
