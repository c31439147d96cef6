import { expect, test } from "vitest";
import { emptyScene } from "../defaults";
import { Formation } from "../formation";
import { mainTrack, type Scene } from "../scene";
import { momentAt } from "../timing";
import { addAgents } from "./agents";
import { addKeyframe, deleteKeyframe, duplicateKeyframe, renameKeyframe, reorderKeyframe } from "./keyframes";
import { retimeKeyframe, rippleKeyframe, setHold } from "./retime";
import { setTransition } from "./transitions";

/** Keyframes at 0, 4, 8, … s in which the one agent stands at x = 0, 1, 2, …; names A, B, C, … */
function show(count: number): Scene {
  let scene = renameKeyframe(0, "A").apply(addAgents([[0, 0]]).apply(emptyScene()));
  for (let i = 1; i < count; i += 1) {
    scene = addKeyframe(4 * (i - 1), Formation.from([[i, 0]])).apply(scene);
    scene = renameKeyframe(i, String.fromCharCode(65 + i)).apply(scene);
  }
  return scene;
}

const times = (scene: Scene) => mainTrack(scene).keyframes.map((keyframe) => keyframe.time);
const names = (scene: Scene) => mainTrack(scene).keyframes.map((keyframe) => keyframe.name);
const places = (scene: Scene) => mainTrack(scene).keyframes.map((keyframe) => keyframe.positions.x(0));

test("a keyframe after the last comes eight counts later", () => {
  expect(times(show(3))).toEqual([0, 4, 8]);
});

test("a keyframe added while agents move is where the playhead is, between the two", () => {
  const methods = setTransition(0, { method: "polar" }).apply(show(2));
  const scene = addKeyframe(1, Formation.from([[0.2, 0]])).apply(methods);
  expect(times(scene)).toEqual([0, 1, 4]);
  expect(places(scene)).toEqual([0, 0.2, 1]);
  expect(mainTrack(scene).segments.map((segment) => segment.method)).toEqual(["polar", "polar"]);
});

test("a keyframe added at a keyframe takes the middle of the way to the next", () => {
  expect(times(addKeyframe(4, Formation.from([[1, 0]])).apply(show(3)))).toEqual([0, 4, 6, 8]);
  expect(times(duplicateKeyframe(0).apply(show(2)))).toEqual([0, 2, 4]);
});

test("a keyframe with other agents than the show's is refused", () => {
  const scene = show(2);
  expect(addKeyframe(0, Formation.from([])).apply(scene)).toBe(scene);
});

test("the last keyframe stays", () => {
  const scene = show(1);
  expect(deleteKeyframe(0).apply(scene)).toBe(scene);
  expect(names(deleteKeyframe(1).apply(show(3)))).toEqual(["A", "C"]);
  expect(names(deleteKeyframe(2).apply(show(3)))).toEqual(["A", "B"]);
  expect(mainTrack(deleteKeyframe(2).apply(show(3))).segments).toHaveLength(1);
});

test("reordering carries formations along while times and holds stay", () => {
  const scene = reorderKeyframe(0, 2).apply(setHold(1, 1).apply(show(4)));
  expect(names(scene)).toEqual(["B", "C", "A", "D"]);
  expect(places(scene)).toEqual([1, 2, 0, 3]);
  expect(times(scene)).toEqual([0, 4, 8, 12]);
  expect(mainTrack(scene).keyframes.map((keyframe) => keyframe.hold)).toEqual([0, 1, 0, 0]);
});

test("a keyframe is dragged no further than its neighbors", () => {
  expect(times(retimeKeyframe(1, 100).apply(show(3)))).toEqual([0, 7.9, 8]);
  expect(times(retimeKeyframe(1, -100).apply(show(3)))).toEqual([0, 0.1, 8]);
  expect(times(retimeKeyframe(1, 100).apply(setHold(1, 2).apply(show(3))))).toEqual([0, 5.9, 8]);
  expect(times(retimeKeyframe(2, 9.00049).apply(show(3)))).toEqual([0, 4, 9]);
});

test("a ripple moves all later keyframes along", () => {
  expect(times(rippleKeyframe(1, 6).apply(show(4)))).toEqual([0, 6, 10, 14]);
  expect(times(rippleKeyframe(1, -6).apply(show(4)))).toEqual([0, 0.1, 4.1, 8.1]);
  expect(times(rippleKeyframe(0, 9000).apply(show(2)))).toEqual([3596, 3600]);
});

test("a hold ends before the next transition needs its time", () => {
  expect(mainTrack(setHold(0, 100).apply(show(2))).keyframes[0]?.hold).toBe(3.9);
});

test("where transitions have no room to spare nothing is pushed", () => {
  const tight = show(3);
  const track = mainTrack(tight);
  const keyframes = track.keyframes.map((keyframe, i) => ({ ...keyframe, time: [0, 0.05, 0.1][i] ?? 0 }));
  const scene = { ...tight, tracks: [{ ...track, keyframes }] };
  expect(retimeKeyframe(1, 3).apply(scene)).toBe(scene);
  expect(addKeyframe(0.02, Formation.from([[0, 0]])).apply(scene)).toBe(scene);
});

test("the playhead stands during a hold and is nearest to one keyframe in between", () => {
  const scene = setHold(0, 1).apply(show(2));
  expect(momentAt(scene, 0.9)).toEqual({ kind: "standing", keyframe: 0 });
  expect(momentAt(scene, 2)).toEqual({ kind: "moving", segment: 0, nearest: 0 });
  expect(momentAt(scene, 3)).toEqual({ kind: "moving", segment: 0, nearest: 1 });
  expect(momentAt(scene, 4)).toEqual({ kind: "standing", keyframe: 1 });
  expect(momentAt(scene, 99)).toEqual({ kind: "standing", keyframe: 1 });
});
