import { expect, test } from "vitest";
import { changesCast, goneIn, presentAt, walkersOf } from "./absence";
import { emptyScene } from "./defaults";
import { mainTrack, type Track } from "./scene";

/** Four agents; by keyframe who is absent. Only the counts and the absent are looked at. */
function track(...absent: readonly (readonly number[])[]): Track {
  const was = mainTrack(emptyScene());
  const [keyframe] = was.keyframes;
  const agents = Array.from({ length: 4 }, () => ({ name: "", color: "", radius: 0.25, maxSpeed: null }));
  return { ...was, agents, keyframes: absent.flatMap((gone) => (keyframe ? [{ ...keyframe, absent: gone }] : [])) };
}

test("who stands at a keyframe is not who walks from it: absent at one end only, one walks", () => {
  const show = track([1, 3], [3], []);
  expect([presentAt(show, 0), presentAt(show, 1), presentAt(show, 2)]).toEqual([
    [0, 2],
    [0, 1, 2],
    [0, 1, 2, 3],
  ]);
  expect([goneIn(show, 0), goneIn(show, 1)]).toEqual([[3], []]);
  expect([walkersOf(show, 0), walkersOf(show, 1)]).toEqual([
    [0, 1, 2],
    [0, 1, 2, 3],
  ]);
  expect(changesCast(show, 1)).toBe(true);
});
