import { signal } from "@preact/signals";
import { expect, test } from "vitest";
import { addAgents, moveAgents } from "./commands/agents";
import { addKeyframe } from "./commands/keyframes";
import { createDocument } from "./create-store";
import { emptyScene } from "./defaults";
import { type Face, seenThrough } from "./face";
import { Formation } from "./formation";
import { front } from "./front";
import { mainTrack, type Scene } from "./scene";

function show(): Scene {
  const scene = addAgents([
    [1, 2],
    [3, 4],
  ]).apply(emptyScene());
  return addKeyframe(4, mainTrack(scene).keyframes[0]?.positions ?? Formation.from([])).apply(scene);
}

function places(scene: Scene, keyframe: number): number[][] {
  const positions = mainTrack(scene).keyframes[keyframe]?.positions;
  return positions ? positions.points().map(([x, y], agent) => [x, y, positions.height(agent)]) : [];
}

test("from the front agents stand at their heights, and their distance is kept", () => {
  expect(places(front.shown(show()), 0)).toEqual([
    [1, 0, 2],
    [3, 0, 4],
  ]);
});

test("who is dragged up from the front is lifted, and every other keyframe stays on the ground", () => {
  const scene = show();
  const dragged = moveAgents(1, new Set([0]), [0.5, 6]).apply(front.shown(scene));
  const lifted = front.meant(dragged, scene);
  expect(places(lifted, 1)).toEqual([
    [1.5, 2, 6],
    [3, 4, 0],
  ]);
  expect(places(lifted, 0)).toEqual(places(scene, 0));
  // Seen again, it is what was dragged.
  expect(places(front.shown(lifted), 1)).toEqual(places(dragged, 1));
});

test("sideways only, a plane scene stays one and what did not change keeps its identity", () => {
  const scene = show();
  const moved = front.meant(moveAgents(1, new Set([0]), [2, 0]).apply(front.shown(scene)), scene);
  expect(mainTrack(moved).keyframes[1]?.positions.heights).toBe(null);
  expect(mainTrack(moved).keyframes[0]).toBe(mainTrack(scene).keyframes[0]);
  expect(moved.stage).toBe(scene.stage);
  expect(front.meant(front.shown(scene), scene)).toBe(scene);
  expect(front.shown(scene)).toBe(front.shown(scene));
});

test("a gesture from the front is one undo entry of the document, canceled it leaves the very scene", () => {
  const document = createDocument(show());
  const face = signal<Face | null>(front);
  const seen = seenThrough(document, face);
  const before = document.scene.peek();
  const canceled = seen.beginGesture();
  canceled.preview(moveAgents(0, new Set([1]), [0, 3]));
  canceled.cancel();
  expect(document.scene.peek()).toBe(before);
  const gesture = seen.beginGesture();
  for (const up of [1, 2, 3]) gesture.preview(moveAgents(0, new Set([1]), [0, up]));
  gesture.commit();
  expect(places(document.scene.peek(), 0)[1]).toEqual([3, 4, 3]);
  document.undo();
  expect(document.scene.peek()).toBe(before);
  face.value = null;
  expect(seen.scene.value).toBe(before);
});
