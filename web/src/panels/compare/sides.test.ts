import { describe, expect, test } from "vitest";
import { DEFAULT_SEGMENT, emptyScene, keyframeAt } from "../../document/defaults";
import { updateTrack } from "../../document/edit";
import { Formation } from "../../document/formation";
import { mainTrack, type Scene } from "../../document/scene";
import { presetsFor, sidesOf } from "./presets";
import { tieChoices, tiedScene } from "./side-ties";
import { changed, commonStart, isInUse, spanOf, takeOver, trialOf } from "./sides";
import { startingSides, transitionAtHand } from "./starting-sides";

/** Four keyframes of one agent: a way, back, and the same way once more. */
function show(): Scene {
  const places = [0, 5, 0, 5].map((x) => Formation.from([[x, 0]]));
  return updateTrack(emptyScene(), (track) => ({
    ...track,
    agents: [{ name: "", color: "", radius: 0.25, maxSpeed: null }],
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

test("each transition is a side as it is, one that comes again goes another way, and one that is not there is none", () => {
  const scene = show();
  const specs = mainTrack(scene).segments;
  expect(startingSides(scene, [0, 1, 2])?.map(({ spec }) => spec)).toEqual(specs);
  expect(startingSides(scene, [1, 1])?.map(({ spec }) => spec.method)).toEqual([specs[1]?.method, "linear"]);
  expect(startingSides(scene, [0, 3])).toBeNull();
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
  const linear = changed({ ...side, spec: { ...side.spec, chosen } }, { options: { method: "linear" } });
  expect(linear.spec.chosen).toBeNull();
  expect(isInUse(scene, linear)).toBe(false);
  expect(isInUse(takeOver(linear).apply(scene), linear)).toBe(true);
});

describe("the ties of a way", () => {
  const group = { name: "", color: "", members: [0], tieWeight: null, children: [] };
  const scene: Scene = { ...show(), groups: [{ ...group, members: [], children: [group] }] };
  const tied: Scene = { ...scene, adjacency: { ...scene.adjacency, ties: [[0, 1, 10]] } };

  test("only those that differ can be chosen", () => {
    expect(tieChoices(show())).toEqual(["own"]);
    expect(tieChoices(scene)).toEqual(["own", "grouped"]);
    expect(tieChoices(tied)).toEqual(["own", "proposed", "grouped"]);
    expect(tieChoices({ ...show(), adjacency: { ...scene.adjacency, cuts: [[0, 1]] } })).toEqual(["own", "proposed"]);
  });

  test("as proposed, nothing by hand is left; groups are tied where they are innermost", () => {
    expect(tiedScene(tied, "proposed")).toEqual(scene);
    const [outer] = tiedScene(tied, "grouped").groups;
    expect([outer?.tieWeight, outer?.children[0]?.tieWeight]).toEqual([null, 10]);
    expect(tiedScene(scene, "proposed")).toBe(scene);
  });

  test("are taken over with it", () => {
    const [side] = startingSides(tied, [1, 1]) ?? [];
    if (!side) throw new Error("the transition is there");
    const grouped = changed(side, { ties: "grouped" });
    expect(isInUse(tied, grouped)).toBe(false);
    expect(isInUse(takeOver(grouped).apply(tied), grouped)).toBe(true);
  });
});

test("the paper's pair of ties is offered where there are ties to tell apart, and four ways take both transitions in turn", () => {
  expect(presetsFor(show()).some(({ id }) => id === "figure-6")).toBe(false);
  const sides = startingSides(show(), [0, 2]) ?? [];
  const figure9 = presetsFor(show()).find(({ id }) => id === "figure-9");
  if (!figure9) throw new Error("figure 9 is there");
  const four = sidesOf(figure9, sides);
  expect(four.map(({ segment }) => segment)).toEqual([0, 2, 0, 2]);
  expect(four.map(({ spec }) => spec.avoidance)).toEqual([false, false, true, true]);
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

test("places that were found are tried, and taken over with the recipe they were found by", () => {
  const two = updateTrack(show(), (track) => ({
    ...track,
    agents: [...track.agents, ...track.agents],
    keyframes: track.keyframes.map((keyframe) => ({ ...keyframe, positions: keyframe.positions.add([[1, 1]]) })),
  }));
  const [side] = startingSides(two, [1, 1]) ?? [];
  if (!side) throw new Error("the transition is there");
  const seated = changed(side, { seating: { cost: "manhattan", slots: [1, 0] } });
  const trial = trialOf(two, seated, commonStart(two, [1]));
  const first = (scene: Scene, keyframe: number) => mainTrack(scene).keyframes[keyframe]?.positions.point(0);
  expect(first(trial.scene, trial.segment)).toEqual(first(two, 1));
  expect(first(trial.scene, trial.segment + 1)).toEqual([1, 1]);
  expect(isInUse(two, seated)).toBe(false);
  const taken = takeOver(seated).apply(two);
  expect([1, 2, 3].map((keyframe) => first(taken, keyframe))).toEqual([first(two, 1), [1, 1], [1, 1]]);
  expect(mainTrack(taken).segments[1]?.assignment?.cost).toBe("manhattan");
  expect(isInUse(two, changed(side, { seating: { cost: "squared", slots: [0, 1] } }))).toBe(true);
});
