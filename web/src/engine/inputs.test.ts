import { expect, test } from "vitest";
import { moveAgents } from "../document/commands/agents";
import { rippleKeyframe } from "../document/commands/retime";
import { DEFAULT_AGENT, DEFAULT_SEGMENT, emptyScene, keyframeAt } from "../document/defaults";
import { Formation } from "../document/formation";
import { type Join, mainTrack, type Scene, type Segment } from "../document/scene";
import { areSame, segmentInputs } from "./inputs";

const COUNT = 9;
const MIDDLE = 4;

function show(join: Join, segment: Partial<Segment> = {}): Scene {
  const keyframes = Array.from({ length: COUNT }, (_, index) => keyframeAt(4 * index, Formation.from([[index, 0]])));
  const segments = Array.from({ length: COUNT - 1 }, () => ({ ...DEFAULT_SEGMENT, ...segment }));
  return { ...emptyScene(), join, tracks: [{ agents: [DEFAULT_AGENT], keyframes, segments }] };
}

/** Which transitions a change asks to be planned anew. */
function changed(before: Scene, after: Scene): number[] {
  return mainTrack(before)
    .segments.map((_, index) => index)
    .filter((index) => !areSame(segmentInputs(before, index), segmentInputs(after, index)));
}

const nudge = moveAgents(MIDDLE, new Set([0]), [1, 0]);

test.each<readonly [string, Scene, number[]]>([
  ["two transitions where they are separate", show("separate"), [3, 4]],
  ["four where they meet with one velocity", show("smooth", { method: "linear" }), [2, 3, 4, 5]],
  ["four as well where spectral ones share nothing", show("smooth", { method: "spectral", sharing: 0 }), [2, 3, 4, 5]],
  ["six where bases are shared", show("smooth", { method: "spectral", sharing: 0.5 }), [1, 2, 3, 4, 5, 6]],
  ["six where auto may yet choose to share", show("smooth"), [1, 2, 3, 4, 5, 6]],
  ["four under the product", show("product", { method: "linear" }), [2, 3, 4, 5]],
])("a moved agent changes %s", (_, scene, expected) => {
  expect(changed(scene, nudge.apply(scene))).toEqual(expected);
});

test.each([
  ["a corner", { corner: true }],
  ["a hold", { hold: 1 }],
])("nothing is felt beyond %s", (_, stop) => {
  const scene = show("smooth", { method: "linear" });
  const track = mainTrack(scene);
  const keyframes = track.keyframes.map((was, index) => (index === MIDDLE + 1 ? { ...was, ...stop } : was));
  const stopped = { ...scene, tracks: [{ ...track, keyframes }] };
  expect(changed(stopped, nudge.apply(stopped))).toEqual([2, 3, 4]);
});

test("tension is felt by those that join, and by none that are separate", () => {
  const smooth = show("smooth");
  expect(changed(smooth, { ...smooth, tension: 0.9 })).toEqual([...mainTrack(smooth).segments.keys()]);
  const separate = show("separate");
  expect(changed(separate, { ...separate, tension: 0.9 })).toEqual([]);
});

test("what moves in time as a whole is planned anew only from where the time changes", () => {
  const scene = show("separate");
  expect(changed(scene, rippleKeyframe(MIDDLE, 17).apply(scene))).toEqual([3, 4, 5, 6, 7]);
});
