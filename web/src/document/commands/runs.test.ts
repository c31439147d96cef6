import { expect, test } from "vitest";
import { DEFAULT_AGENT, DEFAULT_SEGMENT, emptyScene, keyframeAt } from "../defaults";
import { Formation } from "../formation";
import { type Keyframe, mainTrack, type Scene, type Segment } from "../scene";
import { copyOfRun, repeatRun, reverseRun, whyNotRepeated } from "./runs";

const SHARINGS = [0.1, 0.2, 0.3];

/** One agent at x = 0, 1, … by keyframe, with the holds given, each transition of two seconds and told by its sharing. */
function show(holds: readonly number[], places: readonly number[] = holds.map((_, i) => i)): Scene {
  const keyframes: Keyframe[] = [];
  let time = 0;
  holds.forEach((hold, index) => {
    keyframes.push({ ...keyframeAt(time, Formation.from([[places[index] ?? 0, 0]])), hold });
    time += hold + 2;
  });
  const segments: Segment[] = holds.slice(1).map((_, i) => ({ ...DEFAULT_SEGMENT, sharing: SHARINGS[i] ?? 0.5 }));
  return { ...emptyScene(), tracks: [{ agents: [DEFAULT_AGENT], keyframes, segments }] };
}

function story(scene: Scene) {
  const { keyframes, segments } = mainTrack(scene);
  return {
    places: keyframes.map((keyframe) => keyframe.positions.x(0)),
    times: keyframes.map((keyframe) => keyframe.time),
    holds: keyframes.map((keyframe) => keyframe.hold),
    sharings: segments.map((segment) => segment.sharing),
  };
}

test("a reversed run goes backward in the same time, holds and transitions with it", () => {
  const scene = show([1, 0, 3, 0]);
  expect(story(scene).times).toEqual([0, 3, 5, 10]);
  expect(story(reverseRun({ first: 0, last: 2 }).apply(scene))).toEqual({
    places: [2, 1, 0, 3],
    times: [0, 5, 7, 10],
    holds: [3, 0, 1, 0],
    sharings: [0.2, 0.1, 0.3],
  });
});

test("reversed twice, a run is what it was", () => {
  const scene = show([1, 0.3, 3, 0.1]);
  const run = { first: 1, last: 3 };
  expect(story(reverseRun(run).apply(reverseRun(run).apply(scene)))).toEqual(story(scene));
});

test("what auto took for a reversed run and for the ways into and out of it is chosen again", () => {
  const scene = show([0, 0, 0, 0]);
  const choice = { method: "polar", order: "greedy", alignment: "pca", sharing: 0 } as const;
  const track = mainTrack(scene);
  const segments = track.segments.map((segment) => ({ ...segment, chosen: choice }));
  const reversed = reverseRun({ first: 1, last: 2 }).apply({ ...scene, tracks: [{ ...track, segments }] });
  expect(mainTrack(reversed).segments.map((segment) => segment.chosen)).toEqual([null, null, null]);
});

test("a repeated run follows itself, and what comes later moves on", () => {
  const scene = show([1, 0, 0, 0]);
  const run = { first: 0, last: 1 };
  const repeated = repeatRun(run).apply(scene);
  expect(story(repeated)).toEqual({
    places: [0, 1, 0, 1, 2, 3],
    times: [0, 3, 5, 8, 10, 12],
    holds: [1, 0, 1, 0, 0, 0],
    sharings: [0.1, 0.1, 0.1, 0.2, 0.3],
  });
  expect(copyOfRun(scene, run)).toEqual({ first: 2, last: 3 });
});

test("a run that ends where it began goes round without standing twice", () => {
  const scene = show([0.5, 0, 0.5, 0], [0, 1, 0, 7]);
  const run = { first: 0, last: 2 };
  const repeated = repeatRun(run).apply(scene);
  expect(story(repeated)).toEqual({
    places: [0, 1, 0, 1, 0, 7],
    times: [0, 2.5, 4.5, 7, 9, 11.5],
    holds: [0.5, 0, 0.5, 0, 0.5, 0],
    sharings: [0.1, 0.2, 0.1, 0.2, 0.3],
  });
  expect(copyOfRun(scene, run)).toEqual({ first: 3, last: 4 });
});

test("a run that does not fit once more is refused in a sentence", () => {
  const scene = show(Array.from({ length: 120 }, () => 0));
  const run = { first: 0, last: 119 };
  expect(repeatRun(run).apply(scene)).toBe(scene);
  expect(whyNotRepeated(scene, run)).toBe("A scene has at most 200 keyframes.");
});
