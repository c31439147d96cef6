import { expect, test } from "vitest";
import { DEFAULT_AGENT, DEFAULT_SEGMENT, emptyScene, keyframeAt } from "../defaults";
import { Formation } from "../formation";
import { mainTrack, type Scene } from "../scene";
import { swapAgents, takePlaces } from "./swap";

const choice = { method: "polar", order: "greedy", alignment: "pca", sharing: 0 } as const;

const scene: Scene = {
  ...emptyScene(),
  tracks: [
    {
      agents: [DEFAULT_AGENT, DEFAULT_AGENT, DEFAULT_AGENT],
      keyframes: [0, 4, 8].map((time, index) =>
        keyframeAt(
          time,
          Formation.from([
            [index, 0],
            [index, 1],
            [index, 2],
          ]),
        ),
      ),
      segments: [
        { ...DEFAULT_SEGMENT, chosen: choice },
        { ...DEFAULT_SEGMENT, chosen: choice },
      ],
    },
  ],
};

test("two agents change places from a keyframe on, everybody else stays", () => {
  const { keyframes } = mainTrack(swapAgents(1, 0, 2).apply(scene));
  expect(keyframes.map(({ positions }) => positions.points().map(([, y]) => y))).toEqual([
    [0, 1, 2],
    [2, 1, 0],
    [2, 1, 0],
  ]);
});

test("swapped back, the places are the same, and auto chooses where something moved", () => {
  const once = swapAgents(2, 0, 1).apply(scene);
  expect(mainTrack(once).segments.map(({ chosen }) => chosen)).toEqual([choice, null]);
  const twice = swapAgents(2, 0, 1).apply(once);
  expect(mainTrack(twice).keyframes.map(({ positions }) => positions.xy)).toEqual(
    mainTrack(scene).keyframes.map(({ positions }) => positions.xy),
  );
});

test("nobody changes places with themselves or with nobody", () => {
  expect(swapAgents(1, 1, 1).apply(scene)).toBe(scene);
  expect(swapAgents(1, 0, 3).apply(scene)).toBe(scene);
  expect(swapAgents(3, 0, 1).apply(scene)).toBe(scene);
});

test("everybody takes the place given, and only when each place is taken once", () => {
  const { keyframes } = mainTrack(takePlaces(1, [1, 2, 0]).apply(scene));
  expect(keyframes[1]?.positions.points()).toEqual([
    [1, 1],
    [1, 2],
    [1, 0],
  ]);
  expect(takePlaces(1, [1, 1, 0]).apply(scene)).toBe(scene);
  expect(takePlaces(1, [0, 1]).apply(scene)).toBe(scene);
  expect(takePlaces(1, [0, 1, 3]).apply(scene)).toBe(scene);
  expect(takePlaces(1, [0, 1, 2]).apply(scene)).toBe(scene);
});
