import { expect, test } from "vitest";
import { DEFAULT_AGENT, DEFAULT_SEGMENT, emptyScene, keyframeAt } from "../defaults";
import { updateTrack } from "../edit";
import { Formation } from "../formation";
import { mainTrack, type Scene } from "../scene";
import { isStop } from "../stops";
import { setAbsent } from "./absence";
import { deleteAgents } from "./agents";
import { addKeyframe, setBetween } from "./keyframes";
import { swapAgents } from "./swap";

/** Four agents in a row at four keyframes, two seconds apart. */
function show(): Scene {
  const row = () =>
    Formation.from([
      [0, 0],
      [1, 0],
      [2, 0],
      [3, 0],
    ]);
  return updateTrack(emptyScene(), (track) => ({
    ...track,
    agents: Array.from({ length: 4 }, () => DEFAULT_AGENT),
    keyframes: [0, 2, 4, 6].map((time) => keyframeAt(time, row())),
    segments: Array.from({ length: 3 }, () => ({ ...DEFAULT_SEGMENT })),
  }));
}

const absent = (scene: Scene) => mainTrack(scene).keyframes.map((keyframe) => keyframe.absent);

test("who is absent is listed in order, once, and can be brought back", () => {
  const gone = setAbsent(1, new Set([3, 0, 9]), true).apply(setAbsent(1, new Set([3]), true).apply(show()));
  expect(absent(gone)).toEqual([[], [0, 3], [], []]);
  expect(absent(setAbsent(1, new Set([0, 1]), false).apply(gone))).toEqual([[], [3], [], []]);
  expect(setAbsent(1, new Set([0, 3]), true).apply(gone)).toBe(gone);
  expect(setAbsent(1, new Set([1]), false).apply(gone)).toBe(gone);
});

test("who is absent at an in-between ends the transition there, and who was absent already does not", () => {
  const between = setBetween(1, true).apply(show());
  expect(mainTrack(between).keyframes[1]?.between).toBe(1);
  const gone = setAbsent(1, new Set([2]), true).apply(between);
  expect(mainTrack(gone).keyframes[1]).toMatchObject({ between: 0, absent: [2] });
  expect(setAbsent(1, new Set([2]), false).apply(between)).toBe(between);
});

test("a deleted agent is absent nowhere, and the others keep their numbers", () => {
  const gone = setAbsent(2, new Set([1, 3]), true).apply(show());
  expect(absent(deleteAgents(new Set([0, 1])).apply(gone))[2]).toEqual([1]);
});

test("who takes the place of an absent agent is absent", () => {
  const gone = setAbsent(2, new Set([1]), true).apply(setAbsent(0, new Set([1]), true).apply(show()));
  expect(absent(swapAgents(1, 0, 1).apply(gone))).toEqual([[1], [], [0], []]);
});

test("a keyframe within a transition misses whoever is not on the way", () => {
  const both = setAbsent(2, new Set([1, 2]), true).apply(setAbsent(1, new Set([1, 3]), true).apply(show()));
  const seen = mainTrack(both).keyframes[1]?.positions ?? Formation.from([]);
  expect(absent(addKeyframe(3, seen).apply(both))).toEqual([[], [1, 3], [1], [1, 2], []]);
});

test("everybody stops where somebody comes or goes, and nowhere else", () => {
  const track = mainTrack(setAbsent(2, new Set([1]), true).apply(setAbsent(1, new Set([1]), true).apply(show())));
  expect([0, 1, 2, 3].map((keyframe) => isStop(track, "smooth", keyframe))).toEqual([true, true, true, true]);
  const once = mainTrack(setAbsent(1, new Set([1]), true).apply(show()));
  expect([1, 2].map((keyframe) => isStop(once, "smooth", keyframe))).toEqual([false, false]);
});
