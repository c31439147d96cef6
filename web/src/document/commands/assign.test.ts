import { expect, test } from "vitest";
import { DEFAULT_AGENT, DEFAULT_SEGMENT, emptyScene, keyframeAt } from "../defaults";
import { Formation } from "../formation";
import { mainTrack, type Scene } from "../scene";
import { setAbsent } from "./absence";
import { deleteAgents } from "./agents";
import { assignPlaces } from "./assign";

const row = (y: number) => Formation.from([0, 1, 2].map((x) => [x, y] as const));
const scene: Scene = {
  ...emptyScene(),
  tracks: [
    {
      agents: [DEFAULT_AGENT, DEFAULT_AGENT, DEFAULT_AGENT],
      keyframes: [0, 4, 8].map((time, index) => keyframeAt(time, row(index))),
      segments: [DEFAULT_SEGMENT, DEFAULT_SEGMENT],
    },
  ],
};
const recipe = { cost: "squared", lambda: 0.9, locks: [[0, 2]], keepGroups: false } as const;

test("from the target on agents have their places, and a lock reads as one on the agent's own", () => {
  const { keyframes, segments } = mainTrack(assignPlaces(0, [2, 0, 1], recipe).apply(scene));
  const across = keyframes.map(({ positions }) => positions.points().map(([x]) => x));
  expect(across).toEqual([
    [0, 1, 2],
    [2, 0, 1],
    [2, 0, 1],
  ]);
  expect(segments[0]?.assignment).toEqual({ ...recipe, locks: [[0, 0]] });
  expect(segments[1]?.assignment).toBeNull();
});

test("locks follow their agents, and go with them", () => {
  const locked = assignPlaces(0, [2, 0, 1], { ...recipe, locks: [0, 2].map((agent) => [agent, agent] as const) });
  const left = deleteAgents(new Set([0])).apply(locked.apply(scene));
  expect(mainTrack(left).segments[0]?.assignment?.locks).toEqual([[1, 1]]);
});

test("the rest leave, stay where they were, or wait at the places of the absent", () => {
  const gone = setAbsent(1, new Set([0]), true).apply(scene);
  // Agent 2 takes the place of agent 0, who is absent.
  const slots = [2, 1, 0];
  const at = (rest: "leave" | "stay" | "bench") => {
    return mainTrack(assignPlaces(0, slots, recipe, rest).apply(gone)).keyframes[1];
  };
  const before = mainTrack(gone).keyframes;
  expect(at("leave")?.absent).toEqual([2]);
  expect(at("leave")?.positions.point(2)).toEqual(before[1]?.positions.point(0));
  expect(at("bench")?.absent).toEqual([]);
  expect(at("bench")?.positions.point(2)).toEqual(before[1]?.positions.point(0));
  expect(at("stay")?.absent).toEqual([]);
  expect(at("stay")?.positions.point(2)).toEqual(before[0]?.positions.point(2));
  expect(at("stay")?.positions.point(0)).toEqual(before[1]?.positions.point(2));
});
