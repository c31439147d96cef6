import { expect, test } from "vitest";
import { DEFAULT_AGENT, DEFAULT_SEGMENT, emptyScene, keyframeAt } from "../../document/defaults";
import { Formation } from "../../document/formation";
import { bytesWords, exportSize, frameCount } from "./export-size";

const FORMATION = Formation.from([
  [0, 0],
  [1, 0],
]);
const SCENE = {
  ...emptyScene(),
  frameRate: 30,
  tracks: [
    {
      agents: [DEFAULT_AGENT, DEFAULT_AGENT],
      keyframes: [keyframeAt(0, FORMATION), { ...keyframeAt(2, FORMATION), hold: 1 }],
      segments: [DEFAULT_SEGMENT],
    },
  ],
};

test("the frames of a show are those at its frame rate, both ends included", () => {
  expect(frameCount(SCENE)).toBe(91);
});

test("an export has a row an agent and keyframe, or an agent and frame", () => {
  expect(exportSize(SCENE, "keyframes").rows).toBe(4);
  expect(exportSize(SCENE, "csv").rows).toBe(182);
});

test.each([
  [12, "under 1 kB"],
  [34_400, "about 34 kB"],
  [1_240_000, "about 1.2 MB"],
])("%d bytes read as %s", (bytes, words) => {
  expect(bytesWords(bytes)).toBe(words);
});
