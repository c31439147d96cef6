import { expect, test } from "vitest";
import { addAgents, deleteAgents, moveAgents, renameAgent } from "./commands/agents";
import { addKeyframe, deleteKeyframe } from "./commands/keyframes";
import { setTitle } from "./commands/scene";
import { createDocument } from "./create-store";
import { emptyScene } from "./defaults";
import { Formation, type Point } from "./formation";
import { openScene, replaceScene } from "./open-scene";
import { mainTrack } from "./scene";

function documentWith(...places: Point[]) {
  return createDocument(addAgents(places).apply(emptyScene()));
}

const FIRST: ReadonlySet<number> = new Set([0]);

test("a drag is one undo entry however many moves it took", () => {
  const document = documentWith([0, 0], [1, 0]);
  const start = document.scene.value;
  const gesture = document.beginGesture();
  for (let x = 1; x <= 50; x += 1) gesture.preview(moveAgents(0, FIRST, [x, 0]));
  expect(document.isDragging.value).toBe(true);
  gesture.commit();
  expect(document.isDragging.value).toBe(false);
  expect(mainTrack(document.scene.value).keyframes[0]?.positions.point(0)).toEqual([50, 0]);
  expect(document.undoLabel.value).toBe("Move agents");
  document.undo();
  expect(document.scene.value).toBe(start);
  expect(document.undoLabel.value).toBeNull();
  expect(document.redoLabel.value).toBe("Move agents");
});

test("what a gesture previews is accepted when it is committed, not before", () => {
  const document = documentWith([0, 0]);
  const start = document.scene.value;
  const gesture = document.beginGesture();
  gesture.preview(moveAgents(0, FIRST, [3, 0]));
  expect(document.accepted.value).toBe(start);
  gesture.commit();
  expect(document.accepted.value).not.toBe(start);
  expect(document.accepted.value).toBe(document.scene.value);
});

test("a canceled gesture leaves the identical scene and nothing to undo or redo anew", () => {
  const document = documentWith([0, 0]);
  document.perform(setTitle("Opener"));
  document.undo();
  const start = document.scene.value;
  const gesture = document.beginGesture();
  gesture.preview(moveAgents(0, FIRST, [3, 0]));
  gesture.cancel();
  expect(document.scene.value).toBe(start);
  expect(document.undoLabel.value).toBeNull();
  expect(document.redoLabel.value).toBe("Rename scene");
});

test("a drag back to where it began makes no entry", () => {
  const document = documentWith([0, 0]);
  const gesture = document.beginGesture();
  gesture.preview(moveAgents(0, FIRST, [3, 0]));
  gesture.preview(moveAgents(0, FIRST, [0, 0]));
  gesture.commit();
  expect(document.undoLabel.value).toBeNull();
});

test("a command that changes nothing makes no entry and keeps what can be redone", () => {
  const document = documentWith([0, 0]);
  document.perform(setTitle("Opener"));
  document.undo();
  document.perform(setTitle(""));
  expect(document.redoLabel.value).toBe("Rename scene");
});

test("a gesture that is over changes nothing any more", () => {
  const document = documentWith([0, 0]);
  const late = document.beginGesture();
  late.preview(moveAgents(0, FIRST, [3, 0]));
  document.perform(setTitle("Opener"));
  const scene = document.scene.value;
  late.preview(moveAgents(0, FIRST, [9, 0]));
  late.commit();
  late.cancel();
  expect(document.scene.value).toBe(scene);
  expect(mainTrack(scene).keyframes[0]?.positions.point(0)).toEqual([3, 0]);
});

test("steps of one series are one entry until something else is done or undone", () => {
  const document = documentWith([0, 0]);
  const start = document.scene.value;
  const nudge = { ...moveAgents(0, FIRST, [1, 0], "Nudge agents"), series: "nudge" };
  for (let i = 0; i < 5; i += 1) document.perform(nudge);
  document.undo();
  expect(document.scene.value).toBe(start);
  document.redo();
  const nudged = document.scene.value;
  document.perform(nudge);
  document.perform(setTitle("Opener"));
  document.perform(nudge);
  document.undo();
  document.undo();
  document.undo();
  expect(document.scene.value).toBe(nudged);
});

test("undo during a gesture takes back what the gesture shows, and redo brings it again", () => {
  const document = documentWith([0, 0]);
  const start = document.scene.value;
  document.beginGesture().preview(moveAgents(0, FIRST, [3, 0]));
  document.undo();
  expect(document.scene.value).toBe(start);
  expect(document.isDragging.value).toBe(false);
  document.redo();
  expect(mainTrack(document.scene.value).keyframes[0]?.positions.point(0)).toEqual([3, 0]);
});

test("New leaves the old scene one undo away", () => {
  const document = documentWith([0, 0], [1, 1]);
  const old = document.scene.value;
  document.selection.value = { kind: "agents", agents: new Set([1]) };
  openScene(document, emptyScene(), "New scene");
  expect(mainTrack(document.scene.value).agents).toHaveLength(0);
  expect(document.selection.value.kind).toBe("none");
  document.undo();
  expect(document.scene.value).toBe(old);
});

test("a scene brought back as it was left has nothing to undo", () => {
  const document = documentWith([0, 0], [1, 1]);
  document.perform(setTitle("Opener"));
  document.beginGesture().preview(moveAgents(0, FIRST, [3, 0]));
  const left = emptyScene();
  document.start(left);
  expect(document.scene.value).toBe(left);
  expect(document.undoLabel.value).toBeNull();
  expect(document.isDragging.value).toBe(false);
});

test("the selection follows the agents it points at and drops those that are gone", () => {
  const document = documentWith([0, 0], [1, 0], [2, 0], [3, 0]);
  document.selection.value = { kind: "agents", agents: new Set([1, 3]) };
  document.perform(deleteAgents(new Set([0, 1])));
  expect(document.selection.value).toEqual({ kind: "agents", agents: new Set([1]) });
  document.undo();
  expect(document.selection.value).toEqual({ kind: "agents", agents: new Set([3]) });
  document.perform(renameAgent(3, "Ada"));
  expect(document.selection.value).toEqual({ kind: "agents", agents: new Set([3]) });
  document.perform(deleteAgents(new Set([3])));
  expect(document.selection.value).toEqual({ kind: "none" });
});

test("a tie whose agent is gone is no longer selected", () => {
  const document = documentWith([0, 0], [1, 0], [2, 0]);
  document.selection.value = { kind: "tie", a: 1, b: 2 };
  document.perform(deleteAgents(FIRST));
  expect(document.selection.value).toEqual({ kind: "tie", a: 0, b: 1 });
  document.perform(deleteAgents(FIRST));
  expect(document.selection.value).toEqual({ kind: "none" });
});

test("the active keyframe follows its keyframe and always exists", () => {
  const document = documentWith([0, 0]);
  document.perform(addKeyframe(0, Formation.from([[1, 0]])));
  document.perform(addKeyframe(4, Formation.from([[2, 0]])));
  document.selection.value = { kind: "keyframe", index: 2 };
  expect(document.activeKeyframe.value).toBe(2);
  document.perform(deleteKeyframe(1));
  expect(document.selection.value).toEqual({ kind: "keyframe", index: 1 });
  expect(document.activeKeyframe.value).toBe(1);
  document.perform(deleteKeyframe(1));
  expect(document.selection.value).toEqual({ kind: "none" });
  expect(document.activeKeyframe.value).toBe(0);
  document.perform(replaceScene(emptyScene(), "New scene"));
  expect(document.activeKeyframe.value).toBe(0);
});
