import { describe, expect, it } from "vitest";
import { DEFAULT_SEGMENT, keyframeAt } from "../../document/defaults";
import { Formation } from "../../document/formation";
import type { Track } from "../../document/scene";
import { SegmentMotion } from "../../playback/motion";
import { Show } from "../../playback/show";
import type { BodyKind } from "./bodies";
import { gaitsInto } from "./gait";
import { Movement } from "./movement";
import { shortestTurn } from "./orbit";

const SIZES = { disc: 0.25, figure: 1.75, tallest: 1.75, shares: Float32Array.of(1, 1) };

/** One who walks six meters to the right in ten seconds and on in ten, and one who stays; then both stand. */
const track: Track = {
  agents: [],
  keyframes: [
    [0, 0],
    [6, 0],
    [12, 0],
  ].map(([x = 0, y = 0], k) => ({
    ...keyframeAt(
      10 * k,
      Formation.from([
        [x, y],
        [0, 9],
      ]),
    ),
    hold: k === 2 ? 5 : 0,
  })),
  segments: [
    { ...DEFAULT_SEGMENT, timing: "linear" },
    { ...DEFAULT_SEGMENT, timing: "linear" },
  ],
};

function motion(start: number): SegmentMotion {
  const times = Float64Array.from({ length: 301 }, (_, k) => start + k / 30);
  const xy = new Float32Array(4 * times.length);
  for (const [k, time] of times.entries()) xy.set([0.6 * time, 0, 0, 9], 4 * k);
  return new SegmentMotion(times, xy, 2);
}

const planned = new Show(track, [motion(0), motion(10)]);
const blended = new Show(track, []);

function empty() {
  const limbs = {
    leftLeg: new Float32Array(8),
    rightLeg: new Float32Array(8),
    leftArm: new Float32Array(8),
    rightArm: new Float32Array(8),
    posture: new Float32Array(6),
  };
  return { place: new Float32Array(6), ahead: new Float32Array(6), left: new Float32Array(6), limbs };
}

function poses(show: Show, time: number, kind: BodyKind = "figures") {
  const filled = empty();
  new Movement(2).poseInto(show, time, kind, SIZES, filled);
  const [x = 0, y = 0, z = 0] = filled.ahead;
  return {
    ...filled,
    heading: Math.atan2(y, x),
    climb: z,
    /** Sines of the first agent's thighs. */
    thighs: [filled.limbs.leftLeg[1] ?? 0, filled.limbs.rightLeg[1] ?? 0],
    /** How high the hip of each is down. */
    drops: [filled.limbs.posture[0] ?? 0, filled.limbs.posture[3] ?? 0],
  };
}

/** What `gaitsInto` makes of strides of 1.5 m, of somebody of 1.75 m. */
function thighsAfter(strides: number): number[] {
  const { limbs } = empty();
  gaitsInto(Float64Array.of(strides), Float64Array.of(1.5 / 4 / 1.75), limbs);
  return [limbs.leftLeg[1] ?? 0, limbs.rightLeg[1] ?? 0];
}

describe("movement", () => {
  it("steps follow the distance: as many strides on a way as fit, each as long as the others", () => {
    // Six meters are four strides of 1.5 m, so three seconds are 1.2 strides.
    for (const [time, strides] of [
      [3, 1.2],
      [6.5, 2.6],
    ] as const) {
      const { thighs } = poses(planned, time);
      thighsAfter(strides).forEach((thigh, side) => {
        expect(thighs[side]).toBeCloseTo(thigh, 4);
      });
    }
  });

  it("a walk runs on through a keyframe with the same foot", () => {
    // A tenth of a second is 0.04 strides.
    for (const [time, strides] of [
      [9.9, 3.96],
      [10.1, 4.04],
    ] as const) {
      expect(poses(planned, time).thighs[0]).toBeCloseTo(thighsAfter(strides)[0] ?? 0, 4);
    }
  });

  it("who stands has straight legs, also at the moment of starting and stopping", () => {
    for (const time of [0, 20, 22, 25]) expect(poses(planned, time).thighs).toEqual([0, 0]);
    expect(poses(planned, 5).drops[1]).toBe(0);
  });

  it("a walk starts and ends with shorter steps", () => {
    const depth = (time: number) => Math.max(...poses(planned, time).thighs.map(Math.abs));
    expect(depth(0.1)).toBeGreaterThan(0);
    expect(depth(0.1)).toBeLessThan(depth(2.6));
    expect(depth(19.98)).toBeLessThan(depth(17.4));
  });

  it("a straight blend is walked as well", () => {
    const [walked, shown] = [poses(blended, 3), poses(planned, 3)];
    expect(walked.thighs[0]).toBeCloseTo(shown.thighs[0] ?? 0, 4);
  });

  it("a pose depends on the time alone", () => {
    const movement = new Movement(2);
    const filled = empty();
    for (const time of [19, 2, 13.3]) movement.poseInto(planned, time, "figures", SIZES, filled);
    const fresh = empty();
    new Movement(2).poseInto(planned, 13.3, "figures", SIZES, fresh);
    expect(filled).toEqual(fresh);
  });

  it("a corner is turned, not jumped around", () => {
    const times = Float64Array.from({ length: 301 }, (_, k) => k / 30);
    const xy = new Float32Array(4 * times.length);
    for (const [k, time] of times.entries()) xy.set([Math.min(time, 5), Math.max(0, time - 5), 0, 9], 4 * k);
    const way = {
      ...track,
      keyframes: [0, 5].map((x, k) =>
        keyframeAt(
          10 * k,
          Formation.from([
            [x, x],
            [0, 9],
          ]),
        ),
      ),
    };
    const show = new Show(way, [new SegmentMotion(times, xy, 2)]);
    let last = poses(show, 4).heading;
    for (let time = 4; time < 6; time += 1 / 60) {
      const { heading } = poses(show, time);
      expect(Math.abs(shortestTurn(heading - last))).toBeLessThan(0.15);
      last = heading;
    }
    expect(poses(show, 4).heading).toBeCloseTo(0, 0);
    expect(last).toBeCloseTo(Math.PI / 2, 0);
  });

  it("a cone leans into its turn with the inner wing", () => {
    const times = Float64Array.from({ length: 301 }, (_, k) => k / 30);
    const xy = new Float32Array(4 * times.length);
    for (const [k, time] of times.entries()) xy.set([20 * Math.cos(time), 20 * Math.sin(time), 0, 9], 4 * k);
    const ends = [0, 10].map((time) => [20 * Math.cos(time), 20 * Math.sin(time)] as const);
    const round = { ...track, keyframes: ends.map((end, k) => keyframeAt(10 * k, Formation.from([end, [0, 9]]))) };
    const show = new Show(round, [new SegmentMotion(times, xy, 2)]);
    const { ahead, left } = poses(show, 5, "cones");
    expect(left[2]).toBeLessThan(-0.5);
    expect(left[5]).toBeCloseTo(0, 12);
    // Ahead and left are a unit and square to each other.
    for (const agent of [0, 1]) {
      const [a, l] = [ahead, left].map((all) => [...all.subarray(3 * agent, 3 * agent + 3)]);
      const dot = (u: number[] = [], v: number[] = []) =>
        u.reduce((sum, value, axis) => sum + value * (v[axis] ?? 0), 0);
      expect(dot(a, a)).toBeCloseTo(1, 6);
      expect(dot(l, l)).toBeCloseTo(1, 6);
      expect(dot(a, l)).toBeCloseTo(0, 6);
    }
  });

  it("a cone that rises climbs, and a figure stays upright", () => {
    const times = Float64Array.of(0, 10);
    const xy = Float32Array.of(0, 0, 0, 9, 30, 0, 0, 9);
    const ends = [0, 30].map((x, k) => new Formation(Float64Array.of(x, 0, 0, 9), Float64Array.of(30 * k, 4)));
    const up = { ...track, keyframes: ends.map((end, k) => keyframeAt(10 * k, end)) };
    const show = new Show(up, [new SegmentMotion(times, xy, 2, Float32Array.of(0, 4, 30, 4))]);
    const { place, climb, ahead } = poses(show, 5, "cones");
    expect([...place]).toEqual([15, 0, 15, 0, 9, 4]);
    expect(climb).toBeCloseTo(Math.SQRT1_2, 6);
    expect(ahead[5]).toBe(0);
    expect(poses(show, 5, "figures").climb).toBe(0);
  });
});
