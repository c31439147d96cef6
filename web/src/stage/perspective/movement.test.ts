import { describe, expect, it } from "vitest";
import { DEFAULT_SEGMENT, keyframeAt } from "../../document/defaults";
import { Formation } from "../../document/formation";
import type { Track } from "../../document/scene";
import { SegmentMotion } from "../../playback/motion";
import { Show } from "../../playback/show";
import type { BodyKind } from "./bodies";
import { Movement } from "./movement";
import { shortestTurn } from "./orbit";

const SIZES = { disc: 0.25, figure: 1.75 };

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

function poses(show: Show, time: number, kind: BodyKind = "figures") {
  const filled = { place: new Float32Array(8), attitude: new Float32Array(4) };
  new Movement(2).poseInto(show, time, kind, SIZES, filled);
  const [x = 0, y = 0, z = 0, heading = 0] = filled.place;
  const [phase = 0, reach = 0] = filled.attitude;
  return { x, y, z, heading, phase, reach, other: [...filled.attitude.subarray(2)] };
}

describe("movement", () => {
  it("steps follow the distance: as many strides on a way as fit, each as long as the others", () => {
    // Six meters are four strides of 1.5 m, so three seconds are 1.2 strides.
    expect(poses(planned, 3).phase).toBeCloseTo(0.2, 4);
    expect(poses(planned, 6.5).phase).toBeCloseTo(0.6, 4);
    // A foot is a quarter of a stride in front at its farthest.
    expect(poses(planned, 3).reach).toBeCloseTo(1.5 / 4 / 1.75, 4);
  });

  it("a walk runs on through a keyframe with the same foot", () => {
    const [before, after] = [poses(planned, 9.9), poses(planned, 10.1)];
    // A tenth of a second is 0.04 strides.
    expect(before.phase).toBeCloseTo(0.96, 4);
    expect(after.phase).toBeCloseTo(0.04, 4);
    expect(after.reach).toBeCloseTo(before.reach, 4);
  });

  it("who stands has both feet on the ground, also at the moment of starting and stopping", () => {
    for (const time of [0, 20, 22, 25]) expect(poses(planned, time).reach).toBe(0);
    expect(poses(planned, 5).other[1]).toBe(0);
  });

  it("a walk starts and ends with shorter steps", () => {
    expect(poses(planned, 0.05).reach).toBeGreaterThan(0);
    expect(poses(planned, 0.05).reach).toBeLessThan(poses(planned, 1).reach);
    expect(poses(planned, 19.98).reach).toBeLessThan(poses(planned, 19).reach);
  });

  it("a straight blend is walked as well", () => {
    const [walked, shown] = [poses(blended, 3), poses(planned, 3)];
    expect(walked.phase).toBeCloseTo(shown.phase, 4);
    expect(walked.reach).toBeCloseTo(shown.reach, 4);
  });

  it("a pose depends on the time alone", () => {
    const movement = new Movement(2);
    const filled = { place: new Float32Array(8), attitude: new Float32Array(4) };
    for (const time of [19, 2, 13.3]) movement.poseInto(planned, time, "figures", SIZES, filled);
    const fresh = { place: new Float32Array(8), attitude: new Float32Array(4) };
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

  it("cones head along the way and discs lie still", () => {
    expect(poses(planned, 5, "cones").heading).toBeCloseTo(0, 0);
    expect(poses(planned, 5, "discs")).toMatchObject({ heading: 0, phase: 0, reach: 0 });
  });
});
