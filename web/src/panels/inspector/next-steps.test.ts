import { expect, test } from "vitest";
import { DEFAULT_AGENT, DEFAULT_SEGMENT, emptyScene, keyframeAt } from "../../document/defaults";
import { Formation } from "../../document/formation";
import { mainTrack, type Scene, type Segment } from "../../document/scene";
import type { SegmentReport, Suggestion } from "../../engine/api";
import { nextSteps } from "./next-steps";

const NONE = { mean: 0, max: 0 };

function scene(segment: Partial<Segment>): Scene {
  const from = Formation.from([
    [0, 0],
    [4, 0],
  ]);
  const to = Formation.from([
    [4, 0],
    [0, 0],
  ]);
  const agents = [
    { ...DEFAULT_AGENT, name: "Ada" },
    { ...DEFAULT_AGENT, name: "Bo" },
  ];
  const keyframes = [keyframeAt(0, from), keyframeAt(4, to)];
  return { ...emptyScene(), tracks: [{ agents, keyframes, segments: [{ ...DEFAULT_SEGMENT, ...segment }] }] };
}

function report(suggestions?: readonly Suggestion[]): SegmentReport {
  return {
    choice: { method: "spectral", order: "greedy", alignment: "pca", sharing: 0.5 },
    distortion: NONE,
    turning: NONE,
    clearance: { distance: 0.217, time: 2, agents: [0, 1] },
    ...(suggestions ? { suggestions } : {}),
    nearCollisions: 1,
    pathLength: NONE,
    topSpeed: { speed: 0, time: 0, agent: 0 },
    rmsRadius: { min: 0, max: 0 },
    candidates: [],
  };
}

const ALL: readonly Suggestion[] = [
  { kind: "swap", agents: [0, 1] },
  { kind: "assign" },
  { kind: "straight" },
  { kind: "sharing", sharing: 1 },
  { kind: "distance", distance: 0.21 },
  { kind: "keyframe", time: 2 },
];

test("where avoidance is off, turning it on comes before anything else", () => {
  const before = scene({ avoidance: false });
  const [only, ...rest] = nextSteps(before, 0, report());
  expect(rest).toEqual([]);
  expect(only?.label).toBe("Avoid collisions");
  if (only?.does.kind !== "command") throw new Error("it is a command");
  expect(mainTrack(only.does.command.apply(before)).segments[0]?.avoidance).toBe(true);
});

test("what the engine proposes is offered in words, in its order", () => {
  expect(nextSteps(scene({ avoidance: true }), 0, report(ALL)).map(({ label }) => label)).toEqual([
    "Swap Ada and Bo",
    "Nearest places",
    "Straight guide",
    "More sharing",
    "Distance 0.21 m",
    "A keyframe between",
  ]);
});

test("each step does what it says", () => {
  const before = scene({ avoidance: true });
  const after = (label: string): Scene => {
    const found = nextSteps(before, 0, report(ALL)).find((step) => step.label === label);
    if (found?.does.kind !== "command") throw new Error(`${label} is no command`);
    return found.does.command.apply(before);
  };
  expect(mainTrack(after("Swap Ada and Bo")).keyframes[1]?.positions.x(0)).toBe(0);
  expect(mainTrack(after("Straight guide")).segments[0]?.method).toBe("linear");
  expect(mainTrack(after("More sharing")).segments[0]).toMatchObject({ method: "spectral", sharing: 1 });
  expect(after("Distance 0.21 m").minimumDistance).toBe(0.21);
});
