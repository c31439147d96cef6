import { expect, test } from "vitest";
import { emptyScene, keyframeAt } from "../defaults";
import { updateTrack } from "../edit";
import { Formation } from "../formation";
import { mainTrack, type Scene } from "../scene";
import { addAgents, moveAgents } from "./agents";
import { liftAgents, setHeight, settleHeights } from "./heights";

/** Two keyframes of the same three agents on the ground. */
function plane(): Scene {
  const places = Formation.from([
    [0, 0],
    [1, 0],
    [2, 5],
  ]);
  const scene = addAgents(places.points()).apply(emptyScene());
  return updateTrack(scene, (track) => ({ ...track, keyframes: [keyframeAt(0, places), keyframeAt(4, places)] }));
}

function heights(scene: Scene): (number[] | null)[] {
  return mainTrack(scene).keyframes.map(({ positions }) => positions.heights && [...positions.heights]);
}

test("lifting one agent gives every keyframe heights, and the others stand on the ground", () => {
  const lifted = setHeight(1, 2, 3.5).apply(plane());
  expect(heights(lifted)).toEqual([
    [0, 0, 0],
    [0, 0, 3.5],
  ]);
});

test("a scene whose last agent comes down is a plane scene again", () => {
  const lifted = liftAgents(0, new Set([0, 1]), 2).apply(plane());
  const back = liftAgents(0, new Set([0, 1]), -2).apply(lifted);
  expect(heights(back)).toEqual([null, null]);
  expect(mainTrack(back).keyframes[0]?.positions.xy).toBe(mainTrack(lifted).keyframes[0]?.positions.xy);
});

test("ten steps of a decimeter are a meter", () => {
  const step = liftAgents(0, new Set([1]), 0.1);
  let scene = plane();
  for (let k = 0; k < 10; k += 1) scene = step.apply(scene);
  expect(heights(scene)[0]).toEqual([0, 1, 0]);
});

test("what changes nothing leaves the very scene", () => {
  const scene = plane();
  expect(setHeight(0, 1, 0).apply(scene)).toBe(scene);
  expect(setHeight(0, 1, Number.NaN).apply(scene)).toBe(scene);
  expect(liftAgents(9, new Set([1]), 2).apply(scene)).toBe(scene);
  expect(settleHeights(scene)).toBe(scene);
});

test("who moves keeps their height, and heights end where a scene does", () => {
  const lifted = setHeight(0, 0, 1e9).apply(plane());
  const moved = moveAgents(0, new Set([0]), [4, 4]).apply(lifted);
  expect(heights(moved)[0]).toEqual([1e5, 0, 0]);
});
