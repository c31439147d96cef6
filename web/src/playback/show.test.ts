import { describe, expect, it } from "vitest";
import { keyframeAt } from "../document/defaults";
import { Formation, type Point } from "../document/formation";
import { CROWD_DEFAULTS } from "../document/generated";
import type { Keyframe, Segment, Timing, Track } from "../document/scene";
import { SegmentMotion } from "./motion";
import { eased, Show, showDuration } from "./show";

function keyframe(time: number, hold: number, points: readonly Point[]): Keyframe {
  return { ...keyframeAt(time, Formation.from(points)), hold };
}

function segment(timing: Timing): Segment {
  return {
    kind: "transition",
    method: "auto",
    chosen: null,
    order: "greedy",
    alignment: "pca",
    sharing: 0.5,
    keepSize: false,
    timing,
    avoidance: false,
    hierarchy: false,
    nodes: [],
    path: null,
    crowd: CROWD_DEFAULTS,
    assignment: null,
  };
}

const track: Track = {
  agents: [],
  keyframes: [
    keyframe(1, 2, [
      [0, 0],
      [1, 0],
    ]),
    keyframe(7, 0, [
      [4, 0],
      [1, 8],
    ]),
    keyframe(9, 1, [
      [4, 4],
      [1, 0],
    ]),
  ],
  segments: [segment("linear"), segment("smooth")],
};

function at(show: Show, time: number): number[] {
  const out = new Float32Array(4);
  show.positionsInto(time, out);
  return [...out];
}

describe("show", () => {
  const show = new Show(track, []);

  it("lasts until the last formation has stood", () => {
    expect(showDuration(track)).toBe(10);
    expect(show.duration).toBe(10);
  });

  it("agents stand in the first formation before it, through a hold, and in the last one after", () => {
    for (const time of [0, 1, 2.5, 3]) expect(at(show, time)).toEqual([0, 0, 1, 0]);
    for (const time of [9, 9.5, 10, 99]) expect(at(show, time)).toEqual([4, 4, 1, 0]);
  });

  it("without a motion they walk straight, with the segment's timing", () => {
    expect(at(show, 5)).toEqual([2, 0, 1, 4]);
    const t = eased("smooth", 0.25, true, true);
    expect(at(show, 7.5)).toEqual([4, 4 * t, 1, 8 - 8 * t]);
  });

  it("a planned motion is played", () => {
    const motion = new SegmentMotion(Float64Array.of(3, 5, 7), Float32Array.of(0, 0, 1, 0, 9, 9, 9, 9, 4, 0, 1, 8), 2);
    const planned = new Show(track, [motion, null]);
    expect(at(planned, 5)).toEqual([9, 9, 9, 9]);
    expect(at(planned, 4)).toEqual([4.5, 4.5, 5, 4.5]);
    expect(planned.motionOf(0)).toBe(motion);
  });

  it("a placeholder is told from a motion and from a formation that stands", () => {
    const motion = new SegmentMotion(Float64Array.of(3, 7), new Float32Array(8), 2);
    const planned = new Show(track, [motion, null]);
    expect([0, 3, 5, 7, 8, 9, 99].map((time) => planned.isBlendedAt(time))).toEqual([
      ...[false, false, false, false],
      ...[true, false, false],
    ]);
  });

  it("a motion of a scene that has changed since is not played", () => {
    const retimed = new SegmentMotion(Float64Array.of(3, 6), new Float32Array(8), 2);
    const others = new SegmentMotion(Float64Array.of(3, 7), new Float32Array(12), 3);
    for (const stale of [retimed, others]) expect(new Show(track, [stale]).motionOf(0)).toBeNull();
  });

  it("knows what stands and what moves", () => {
    expect([0, 3, 3.01, 7, 8, 9, 11].map((time) => show.segmentAt(time))).toEqual([null, null, 0, null, 1, null, null]);
    expect([0, 3.01, 7, 11].map((time) => show.keyframeBefore(time))).toEqual([0, 0, 1, 2]);
  });

  it("one keyframe stands for ever", () => {
    const single = new Show({ ...track, keyframes: track.keyframes.slice(0, 1), segments: [] }, []);
    expect(at(single, 50)).toEqual([0, 0, 1, 0]);
    expect(single.duration).toBe(3);
  });

  it("in space, heights stand, are planned and blended as places are", () => {
    const lifted = track.keyframes.map((frame, k) => ({
      ...frame,
      positions: new Formation(frame.positions.xy, Float64Array.of(2 * k, 10)),
    }));
    const motion = new SegmentMotion(
      Float64Array.of(3, 5, 7),
      new Float32Array(12),
      2,
      Float32Array.of(0, 10, 8, 9, 2, 10),
    );
    const inSpace = new Show({ ...track, keyframes: lifted }, [motion]);
    const heights = (at: Show, time: number) => {
      const out = new Float32Array(2).fill(99);
      at.heightsInto(time, out);
      return [...out];
    };
    expect(inSpace.isSpatial).toBe(true);
    expect(heights(inSpace, 2)).toEqual([0, 10]);
    expect(heights(inSpace, 4)).toEqual([4, 9.5]);
    expect(heights(inSpace, 8)).toEqual([3, 10]);
    expect(heights(show, 5)).toEqual([0, 0]);
    expect(show.isSpatial).toBe(false);
  });
});

it.each([
  ["stands at both ends that are stops", true, true, 0, 0],
  ["runs on through an end that is none", true, false, 0, 1],
  ["comes in at full speed", false, true, 1, 0],
  ["is even where nobody stops", false, false, 1, 1],
])("smooth timing %s", (_, before, after, startSpeed, endSpeed) => {
  const at = (t: number) => eased("smooth", t, before, after);
  const step = 1e-6;
  expect(at(0)).toBe(0);
  expect(at(1)).toBe(1);
  // A difference over such a step is off by half of it times the curvature, which is 6 at most.
  expect(at(step) / step).toBeCloseTo(startSpeed, 4);
  expect((1 - at(1 - step)) / step).toBeCloseTo(endSpeed, 4);
});

describe("who is absent", () => {
  const gone: Track = {
    ...track,
    keyframes: track.keyframes.map((was, index) => ({ ...was, absent: index === 0 ? [0, 1] : [1] })),
  };
  it("is not there while the others stand, nor on the way between two such keyframes", () => {
    const show = new Show(gone, []);
    expect(show.absentAt(2)).toEqual([0, 1]);
    expect(show.absentAt(5)).toEqual([1]);
    expect(show.absentAt(7)).toEqual([1]);
    expect(new Show(track, []).absentAt(5)).toEqual([]);
  });
});
