import { beforeEach, expect, test } from "vitest";
import { setHold } from "../../document/commands/retime";
import { createDocument } from "../../document/create-store";
import { DEFAULT_AGENT, DEFAULT_SEGMENT, emptyScene, keyframeAt } from "../../document/defaults";
import { Formation } from "../../document/formation";
import { mainTrack, type Scene } from "../../document/scene";
import type { DocumentStore } from "../../document/store";
import { KeyframeDrag } from "./keyframe-drag";
import { type Scale, xOf } from "./scale";

const SCALE: Scale = { origin: 60, pixelsPerSecond: 100 };
const FAR_AWAY = 1000;

function show(): Scene {
  const keyframes = [0, 4, 8].map((time, index) => ({
    ...keyframeAt(time, Formation.from([[index, 0]])),
    name: `K${index}`,
  }));
  const track = { agents: [DEFAULT_AGENT], keyframes, segments: [DEFAULT_SEGMENT, DEFAULT_SEGMENT] };
  return { ...emptyScene(), tracks: [track] };
}

let document: DocumentStore;
let drag: KeyframeDrag;

beforeEach(() => {
  document = createDocument(show());
  drag = new KeyframeDrag(document, { scale: () => SCALE, ruler: () => "seconds" });
});

const times = () => mainTrack(document.scene.value).keyframes.map(({ time }) => time);
const names = () => mainTrack(document.scene.value).keyframes.map(({ name }) => name);

function pull(from: number, to: number, isRipple = false): void {
  drag.press(1, from, FAR_AWAY);
  const steps = 7;
  for (let step = 1; step <= steps; step += 1) {
    drag.move({ x: from + ((to - from) * step) / steps, isRipple });
  }
}

test("a press that hardly moves is a click and changes nothing", () => {
  drag.press(1, 460, 4);
  drag.move({ x: 462, isRipple: false });
  expect(drag.release()).toBeNull();
  expect(document.undoLabel.value).toBeNull();
});

test("a drag retimes one keyframe and is one undo entry however many moves it took", () => {
  const before = document.scene.value;
  pull(460, 560);
  expect(times()).toEqual([0, 5, 8]);
  expect(drag.release()).toBe(1);
  document.undo();
  expect(document.scene.value).toBe(before);
});

test("with Alt the later keyframes move along", () => {
  pull(460, 560, true);
  drag.release();
  expect(times()).toEqual([0, 5, 9]);
});

test("Escape leaves the identical scene", () => {
  const before = document.scene.value;
  pull(460, 560);
  drag.cancel();
  expect(document.scene.value).toBe(before);
  expect(document.undoLabel.value).toBeNull();
});

test("a keyframe never passes its neighbors", () => {
  pull(460, 1400);
  drag.release();
  const [first, second, third] = times();
  expect(second).toBeGreaterThan(first ?? 0);
  expect(second).toBeLessThan(third ?? 0);
  expect(names()).toEqual(["K0", "K1", "K2"]);
});

test("pulled past what its neighbors leave, it says where it was stopped, until it follows again", () => {
  const stop = () => (drag.state.value.kind === "retiming" ? drag.state.value.stop : undefined);
  document.perform(setHold(0, 2));
  pull(460, xOf(SCALE, 1));
  expect(stop()).toBe(times()[1]);
  drag.move({ x: xOf(SCALE, 3), isRipple: false });
  expect(stop()).toBeNull();
});

test("dropped onto another it takes that place, and the times stay", () => {
  pull(460, xOf(SCALE, 8) + 5);
  expect(times()).toEqual([0, 4, 8]);
  expect(drag.release()).toBe(2);
  expect(names()).toEqual(["K0", "K2", "K1"]);
  expect(times()).toEqual([0, 4, 8]);
});

test("pulled away from another again it retimes and does not reorder", () => {
  pull(460, xOf(SCALE, 8));
  drag.move({ x: 600, isRipple: false });
  drag.release();
  expect(names()).toEqual(["K0", "K1", "K2"]);
  expect(times()[1]).toBeCloseTo(5.4, 9);
});

test("the place where the drag began is where it ends when the pointer comes back", () => {
  pull(460, 560);
  drag.move({ x: 460, isRipple: false });
  drag.release();
  expect(times()).toEqual([0, 4, 8]);
});

test("the playhead that goes along with a dragged keyframe does not hold it back", () => {
  drag.press(1, 460, 4);
  for (let x = 461; x <= 520; x += 1) drag.move({ x, isRipple: false });
  expect(times()[1]).toBeCloseTo(4.6, 9);
});

test("where counts are read, a drag goes from count to count", () => {
  drag = new KeyframeDrag(document, { scale: () => SCALE, ruler: () => "counts" });
  pull(460, 537);
  drag.release();
  expect(times()).toEqual([0, 5, 8]);
});
