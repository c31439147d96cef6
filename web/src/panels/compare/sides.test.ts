import { describe, expect, test } from "vitest";
import { DEFAULT_SEGMENT, emptyScene, keyframeAt } from "../../document/defaults";
import { updateTrack } from "../../document/edit";
import { Formation } from "../../document/formation";
import { mainTrack, type Scene } from "../../document/scene";
import { commonStart, isInUse, optionsOf, spanOf, trialOf, withOptions } from "./sides";
import { startingSides, transitionAtHand } from "./starting-sides";

/** Four keyframes of one agent: a way, back, and the same way once more. */
function show(): Scene {
  const places = [0, 5, 0, 5].map((x) => Formation.from([[x, 0]]));
  return updateTrack(emptyScene(), (track) => ({
    ...track,
    agents: [{ name: "", color: "", radius: 0.25 }],
    keyframes: places.map((place, index) => ({ ...keyframeAt(6 * index, place), hold: 1 })),
    segments: places.slice(1).map(() => DEFAULT_SEGMENT),
  }));
}

describe("what is planned for a side", () => {
  const scene = show();
  const [left, right] = startingSides(scene, [0, 2]) ?? [];
  if (!left || !right) throw new Error("both transitions are there");
  const start = commonStart(scene, [0, 2]);

  test("both sides leave at the same moment and arrive as late as in the show", () => {
    for (const side of [left, right]) {
      const trial = trialOf(scene, side, start);
      expect(spanOf(trial.scene, trial.segment)).toEqual({ start, end: start + 5 });
    }
  });

  test("nothing happens before time begins", () => {
    for (const side of [left, right]) {
      const times = mainTrack(trialOf(scene, side, start).scene).keyframes.map(({ time }) => time);
      expect(Math.min(...times)).toBeGreaterThanOrEqual(0);
    }
  });

  test("formations keep their identity, so that they cross to the engine once", () => {
    const { scene: tried, segment } = trialOf(scene, right, start);
    expect(mainTrack(tried).keyframes[segment]?.positions).toBe(mainTrack(scene).keyframes[2]?.positions);
  });
});

test("where motion runs through the keyframes, a trial has the neighbors that shape it", () => {
  const scene = { ...show(), join: "smooth" as const };
  const [left, right] = startingSides(scene, [0, 2]) ?? [];
  if (!left || !right) throw new Error("both transitions are there");
  const start = commonStart(scene, [0, 2]);
  const trials = [left, right].map((side) => trialOf(scene, side, start));
  expect(trials.map((trial) => mainTrack(trial.scene).keyframes.length)).toEqual([4, 4]);
  for (const { scene: tried, segment } of trials) expect(spanOf(tried, segment)).toEqual({ start, end: start + 5 });
  expect(Math.min(...trials.flatMap((trial) => mainTrack(trial.scene).keyframes.map(({ time }) => time)))).toBe(0);
});

test("a changed option is the person's own choice, and in use once it is the scene's", () => {
  const scene = show();
  const [side] = startingSides(scene, [1, 1]) ?? [];
  if (!side) throw new Error("the transition is there");
  expect(isInUse(scene, side)).toBe(true);
  const chosen = { method: "polar", order: "greedy", alignment: "pca", sharing: 0 } as const;
  const changed = withOptions({ ...side, spec: { ...side.spec, chosen } }, { method: "linear" });
  expect(changed.spec.chosen).toBeNull();
  expect(isInUse(scene, changed)).toBe(false);
  expect(optionsOf(changed)).not.toHaveProperty("chosen");
});

test("one transition starts beside the way everybody knows, a straight one beside the eigenbases", () => {
  const scene = show();
  expect(startingSides(scene, [1, 1])?.map(({ spec }) => spec.method)).toEqual(["auto", "linear"]);
  const straight = updateTrack(scene, (track) => ({
    ...track,
    segments: track.segments.map((segment) => ({ ...segment, method: "linear" as const })),
  }));
  expect(startingSides(straight, [1, 1])?.map(({ spec }) => spec.method)).toEqual(["linear", "spectral"]);
  expect(startingSides(scene, [0, 7])).toBeNull();
});

test("the transition at hand is the selected one, else the one at the playhead, and at the end the last", () => {
  const scene = show();
  expect(transitionAtHand(scene, { kind: "transition", index: 1 }, 0)).toBe(1);
  expect(transitionAtHand(scene, { kind: "none" }, 8)).toBe(1);
  expect(transitionAtHand(scene, { kind: "none" }, 99)).toBe(2);
});
