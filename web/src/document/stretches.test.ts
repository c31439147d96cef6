import { expect, test } from "vitest";
import { areSame, segmentInputs } from "../engine/inputs";
import { mayLieBetween } from "./between";
import { addAgents, moveAgents, placeAgents } from "./commands/agents";
import {
  addKeyframe,
  deleteKeyframe,
  duplicateKeyframe,
  reorderKeyframe,
  setBetween,
  setCorner,
} from "./commands/keyframes";
import { setHold } from "./commands/retime";
import { repeatRun, reverseRun, whyNotRepeated, whyNotReversed } from "./commands/runs";
import { setTransition } from "./commands/transitions";
import { setPath } from "./commands/travel";
import { DEFAULT_SEGMENT, emptyScene, keyframeAt } from "./defaults";
import { Formation } from "./formation";
import { type Choice, type Join, mainTrack, type Scene } from "./scene";
import { isStop } from "./stops";
import { endsAround, liesBetween, stretchesOf } from "./stretches";

const TAKEN: Choice = { method: "polar", order: "greedy", alignment: "pca", sharing: 0.5 };

/** Two agents at keyframes every 4 s. */
function show(count = 4, join: Join = "smooth"): Scene {
  const scene = addAgents([
    [0, 0],
    [0, 1],
  ]).apply(emptyScene());
  const keyframes = Array.from({ length: count }, (_, k) =>
    keyframeAt(
      4 * k,
      Formation.from([
        [k, 0],
        [k, 1],
      ]),
    ),
  );
  const segments = keyframes.slice(1).map(() => ({ ...DEFAULT_SEGMENT }));
  return { ...scene, join, tracks: [{ ...mainTrack(scene), keyframes, segments }] };
}

const seen = Formation.from([
  [1.5, 0],
  [1.5, 1],
]);

/** The second transition with a keyframe between, seen at 6 s. */
const bent = (scene = show(), taken: Choice | null = TAKEN) => addKeyframe(6, seen, taken).apply(scene);

const anchors = (scene: Scene) => stretchesOf(mainTrack(scene)).anchors;
const segments = (scene: Scene) => mainTrack(scene).segments;

test("a keyframe added while agents move lies between, and auto goes on as it did", () => {
  const scene = bent();
  expect(anchors(scene)).toEqual([0, 1, 3, 4]);
  expect(segments(scene).map((segment) => segment.chosen)).toEqual([null, TAKEN, TAKEN, null]);
  expect(endsAround(mainTrack(scene), 1)).toEqual([1, 3]);
  expect(endsAround(mainTrack(scene), 2)).toEqual([1, 3]);
  expect(endsAround(mainTrack(scene), 3)).toEqual([3, 4]);
});

test("one added where agents stand, and a copy, are formations of their own", () => {
  expect(anchors(addKeyframe(4, seen).apply(show()))).toEqual([0, 1, 2, 3, 4]);
  expect(anchors(duplicateKeyframe(2).apply(bent()))).toEqual([0, 1, 3, 4, 5]);
});

test("agents pass it, whatever the join", () => {
  for (const join of ["separate", "smooth", "product"] as const) {
    expect(isStop(mainTrack(bent(show(4, join))), join, 2)).toBe(false);
  }
});

test("what is chosen for a part is chosen for the whole transition, as one step", () => {
  for (const part of [1, 2]) {
    const scene = setTransition(part, { method: "linear", avoidance: false }).apply(bent());
    expect(segments(scene).map((segment) => segment.method)).toEqual(["auto", "linear", "linear", "auto"]);
    expect(segments(scene).map((segment) => segment.chosen)).toEqual([null, null, null, null]);
    expect(segments(scene)[1]).not.toBe(segments(scene)[2]);
  }
});

test("a moved agent between lets auto keep what it took; at an end it chooses again", () => {
  const move = (keyframe: number) => moveAgents(keyframe, new Set([0]), [1, 0]).apply(bent());
  expect(segments(move(2)).map((segment) => segment.chosen)).toEqual([null, TAKEN, TAKEN, null]);
  for (const end of [1, 3])
    expect(segments(move(end)).map((segment) => segment.chosen)).toEqual([null, null, null, null]);
});

test("a moved agent between changes the parts at its keyframe and no other transition", () => {
  const twice = addKeyframe(5, seen, TAKEN).apply(bent());
  const moved = moveAgents(2, new Set([0]), [1, 0]).apply(twice);
  const changed = [...segments(twice).keys()].filter(
    (index) => !areSame(segmentInputs(twice, index), segmentInputs(moved, index)),
  );
  expect(anchors(twice)).toEqual([0, 1, 4, 5]);
  expect(changed).toEqual([1, 2, 3]);
});

test("a corner, a hold, a new place for everybody and the switch end the transition there", () => {
  const places = placeAgents(
    2,
    [0, 1],
    [
      [3, 3],
      [4, 4],
    ],
    [0, 1],
  );
  for (const command of [setCorner(2, true), setHold(2, 0.5), places, setBetween(2, false)]) {
    const scene = command.apply(bent());
    expect(liesBetween(mainTrack(scene), 2)).toBe(false);
    expect(mayLieBetween(mainTrack(scene), 2)).toBe(true);
    expect(anchors(setBetween(2, true).apply(scene))).toEqual([0, 1, 3, 4]);
  }
  expect(liesBetween(mainTrack(placeAgents(2, [1], [[3, 3]], [0]).apply(bent())), 2)).toBe(true);
});

test("both ends of a show, and where others come, end one always", () => {
  const scene = bent();
  const track = mainTrack(scene);
  expect([0, 4].map((end) => mayLieBetween(track, end))).toEqual([false, false]);
  const keyframes = track.keyframes.map((was, index) => (index < 2 ? { ...was, absent: [1] } : was));
  expect(mayLieBetween({ ...track, keyframes }, 2)).toBe(true);
  expect(mayLieBetween({ ...track, keyframes }, 1)).toBe(false);
});

test("a path is that of the whole transition; it is cut where that ends and joined where two become one", () => {
  const path = [
    [1, 0.5],
    [1.5, 4],
    [2, 0.5],
  ] as const;
  const scene = setPath(2, path, "Draw path").apply(bent());
  expect(segments(scene).map((segment) => segment.path)).toEqual([null, path, path, null]);
  const cut = segments(setBetween(2, false).apply(scene)).map((segment) => segment.path);
  expect(cut[1]?.at(-1)).toEqual(cut[2]?.[0]);
  expect([cut[1]?.[0], cut[2]?.at(-1)]).toEqual([path[0], path[2]]);
  const joined = segments(setBetween(2, true).apply(setBetween(2, false).apply(scene)))[1]?.path;
  expect([joined?.[0], joined?.at(-1)]).toEqual([path[0], path[2]]);
});

test("without its end a transition goes on to the next, and what lay between lies there", () => {
  const scene = deleteKeyframe(3).apply(bent());
  expect(anchors(scene)).toEqual([0, 1, 3]);
  const first = deleteKeyframe(1).apply(bent());
  expect(anchors(first)).toEqual([0, 2, 3]);
  expect(segments(deleteKeyframe(2).apply(bent()))).toHaveLength(3);
});

test("one added at an in-between lies halfway to the next and lies between, too", () => {
  const scene = addKeyframe(6, seen, TAKEN).apply(bent());
  expect(mainTrack(scene).keyframes.map((keyframe) => keyframe.time)).toEqual([0, 4, 6, 7, 8, 12]);
  expect(anchors(scene)).toEqual([0, 1, 4, 5]);
});

test("what becomes an end of the show is no in-between any longer, whatever comes behind it later", () => {
  const short = deleteKeyframe(4).apply(deleteKeyframe(3).apply(bent()));
  const longer = addKeyframe(12, seen).apply(deleteKeyframe(3).apply(short));
  expect(mainTrack(longer).keyframes.every((keyframe) => keyframe.between === 0)).toBe(true);
  expect(anchors(longer)).toEqual([...mainTrack(longer).keyframes.keys()]);
});

test("a run that cuts a transition is neither reversed nor repeated, and the reason is told", () => {
  const scene = bent();
  for (const run of [
    { first: 0, last: 2 },
    { first: 2, last: 4 },
  ]) {
    expect(reverseRun(run).apply(scene)).toBe(scene);
    expect(repeatRun(run).apply(scene)).toBe(scene);
    expect(whyNotReversed(scene, run)).toContain("in-between");
    expect(whyNotRepeated(scene, run)).toContain("in-between");
  }
  const whole = { first: 1, last: 3 };
  expect(anchors(reverseRun(whole).apply(scene))).toEqual([0, 1, 3, 4]);
  expect(anchors(repeatRun(whole).apply(scene))).toEqual([0, 1, 3, 4, 6, 7]);
});

test("a formation in another place in the order leaves no in-between to bend what it does not belong in", () => {
  expect(anchors(reorderKeyframe(3, 4).apply(bent()))).toEqual([0, 1, 2, 3, 4]);
  expect(anchors(reorderKeyframe(4, 0).apply(addKeyframe(10, seen).apply(bent())))).toEqual([0, 1, 2, 3, 4, 5]);
});

test("a path that is cut and joined again is the same, and one path alone goes on straight", () => {
  const path = [
    [1, 0.5],
    [1.5, 4],
    [2, 0.5],
  ] as const;
  const scene = setPath(1, path, "Draw path").apply(bent());
  const again = setCorner(2, false).apply(setCorner(2, true).apply(scene));
  expect(segments(again)[1]?.path).toEqual(path);
  const parted = setPath(2, null, "Remove path").apply(setBetween(2, false).apply(scene));
  const joined = segments(setBetween(2, true).apply(parted))[1]?.path;
  expect([joined?.[0], joined?.at(-1)]).toEqual([path[0], [2, 0.5]]);
});

test("one more beside an in-between lies deeper than it", () => {
  const depths = (scene: Scene) => mainTrack(scene).keyframes.map((keyframe) => keyframe.between);
  const twice = addKeyframe(5, seen, TAKEN).apply(bent());
  expect(depths(twice)).toEqual([0, 0, 2, 1, 0, 0]);
  expect(depths(addKeyframe(5.5, seen, TAKEN).apply(twice))).toEqual([0, 0, 2, 3, 1, 0, 0]);
  expect(depths(setBetween(3, true).apply(setBetween(3, false).apply(twice)))).toEqual([0, 0, 2, 3, 0, 0]);
});
