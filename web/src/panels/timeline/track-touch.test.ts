import { signal } from "@preact/signals";
import { expect, test } from "vitest";
import { createDocument } from "../../document/create-store";
import { DEFAULT_AGENT, DEFAULT_SEGMENT, emptyScene, keyframeAt } from "../../document/defaults";
import { Formation } from "../../document/formation";
import { createPlayback } from "../../playback/playback";
import { timeAt } from "./scale";
import { TrackTouch } from "./track-touch";
import { createViewport, type Viewport } from "./viewport";

/** A minute of show in a window of 400 pixels. */
function longShow(): Viewport {
  const times = [0, 10, 20, 30, 40, 50, 60];
  const keyframes = times.map((time) => keyframeAt(time, Formation.from([[0, 0]])));
  const segments = times.slice(1).map(() => DEFAULT_SEGMENT);
  const document = createDocument({ ...emptyScene(), tracks: [{ agents: [DEFAULT_AGENT], keyframes, segments }] });
  const viewport = createViewport(document, createPlayback(signal(60)));
  viewport.width.value = 400;
  return viewport;
}

test("one finger pulls the timeline along, and what was pulled is not tapped", () => {
  const viewport = longShow();
  const touch = new TrackTouch(viewport);
  touch.down(1, 300);
  touch.move(1, 200, 0);
  touch.up(1);
  expect(viewport.scroll.value).toBe(100);
  expect(touch.takesClick()).toBe(true);
  expect(touch.takesClick()).toBe(false);
});

test("a tap scrolls nothing", () => {
  const viewport = longShow();
  const touch = new TrackTouch(viewport);
  touch.down(1, 300);
  touch.move(1, 303, 0);
  touch.up(1);
  expect(viewport.scroll.value).toBe(0);
  expect(touch.takesClick()).toBe(false);
});

test("two fingers zoom by how far they part", () => {
  const viewport = longShow();
  const before = viewport.scale.value.pixelsPerSecond;
  const touch = new TrackTouch(viewport);
  touch.down(1, 150);
  touch.down(2, 250);
  for (let x = 250; x <= 350; x += 10) touch.move(2, x, 0);
  expect(viewport.scale.value.pixelsPerSecond / before).toBeCloseTo(2, 6);
});

test("zooming by the wheel keeps the time under the pointer, and the timeline never scrolls past its ends", () => {
  const viewport = longShow();
  viewport.scrollTo(300);
  const at = () => timeAt(viewport.scale.value, viewport.scroll.value + 130);
  const before = at();
  viewport.zoomBy(1.7, 130);
  expect(at()).toBeCloseTo(before, 9);
  viewport.scrollTo(-50);
  expect(viewport.scroll.value).toBe(0);
  viewport.scrollTo(1e9);
  expect(viewport.scroll.value).toBe(viewport.trackWidth.value - 400);
});

test("a drag that lengthens the show does not move the ground beneath it", () => {
  const document = createDocument({
    ...emptyScene(),
    tracks: [
      {
        agents: [DEFAULT_AGENT],
        keyframes: [0, 10].map((time) => keyframeAt(time, Formation.from([[0, 0]]))),
        segments: [DEFAULT_SEGMENT],
      },
    ],
  });
  const duration = signal(10);
  const viewport = createViewport(document, createPlayback(duration));
  viewport.width.value = 1440;
  const before = viewport.scale.value.pixelsPerSecond;
  const gesture = document.beginGesture();
  gesture.preview({ label: "Lengthen", apply: (scene) => ({ ...scene }) });
  duration.value = 14;
  expect(viewport.scale.value.pixelsPerSecond).toBe(before);
  gesture.commit();
  expect(viewport.scale.value.pixelsPerSecond).toBeLessThan(before);
});
