import { computed, type ReadonlySignal, type Signal, signal } from "@preact/signals";
import { type Keyframe, mainTrack } from "../../document/scene";
import type { DocumentStore } from "../../document/store";
import type { Playback } from "../../playback/playback";
import {
  clampZoom,
  fittedZoom,
  type Margins,
  type Scale,
  scrollAfterZoom,
  scrollToReveal,
  trackWidth,
  xOf,
} from "./scale";

/** Which part of the timeline is seen, and how large. Never part of the scene nor of undo. */
export interface Viewport {
  /** CSS pixels of the track's window. */
  readonly width: Signal<number>;
  readonly scroll: ReadonlySignal<number>;
  readonly scale: ReadonlySignal<Scale>;
  readonly trackWidth: ReadonlySignal<number>;
  /** Whether not everything fits the window. */
  readonly isCut: ReadonlySignal<boolean>;
  /** What is worth drawing, in track pixels: the window and some more, in steps, so that scrolling seldom redraws. */
  readonly drawn: ReadonlySignal<{ readonly from: number; readonly to: number }>;
  scrollTo(x: number): void;
  /** @param pointer CSS pixels from the window's left edge: what is there stays there */
  zoomBy(factor: number, pointer: number): void;
  /** Whether a time is in the window now; asked every frame, outside of effects. */
  isSeen(time: number): boolean;
  reveal(time: number): void;
  /** Track pixels of a pointer over `element`, which is anywhere in the timeline. */
  trackX(clientX: number, element: Element): number;
}

const DRAWN_STEP = 400;

/** A drag that retimes must not move the ground beneath it, so the fitted zoom waits until it ends. */
export function createViewport(document: DocumentStore, playback: Playback): Viewport {
  const width = signal(0);
  const position = signal(0);
  const zoom = signal<number | null>(null);
  let fitted = 0;

  const margins = computed<Margins>(() =>
    width.value <= 640 ? { lead: 41, tail: 60 } : { lead: 62, tail: Math.min(150, width.value / 8) },
  );
  const scale = computed<Scale>(() => {
    const keyframes = mainTrack(document.scene.value).keyframes;
    if (zoom.value === null && !(document.isDragging.value && fitted > 0)) {
      const intervals = keyframes.slice(1).map((next, index) => next.time - departure(keyframes[index]));
      fitted = fittedZoom(intervals, playback.duration.value, width.value, margins.value);
    }
    return { origin: margins.value.lead, pixelsPerSecond: zoom.value ?? fitted };
  });
  const whole = computed(() => trackWidth(scale.value, playback.duration.value, width.value, margins.value));
  const scroll = computed(() => Math.min(Math.max(0, position.value), whole.value - width.value));
  const firstStep = computed(() => Math.floor(scroll.value / DRAWN_STEP));
  const drawn = computed(() => ({
    from: (firstStep.value - 1) * DRAWN_STEP,
    to: (firstStep.value + 2) * DRAWN_STEP + width.value,
  }));

  return {
    width,
    scroll,
    scale,
    trackWidth: whole,
    isCut: computed(() => width.value > 0 && whole.value > width.value + 1),
    drawn,
    scrollTo(x) {
      position.value = Math.min(Math.max(0, x), whole.value - width.value);
    },
    zoomBy(factor, pointer) {
      const before = scale.value;
      const from = scroll.value;
      zoom.value = clampZoom(before.pixelsPerSecond * factor);
      position.value = scrollAfterZoom(before, scale.value, from, pointer);
    },
    isSeen(time) {
      const x = xOf(scale.value, time) - scroll.value;
      return x >= 0 && x <= width.value;
    },
    reveal(time) {
      position.value = scrollToReveal(xOf(scale.peek(), time), scroll.peek(), width.peek());
    },
    trackX(clientX, element) {
      const window = element.closest(".track-window") ?? element;
      return clientX - window.getBoundingClientRect().left + scroll.peek();
    },
  };
}

function departure(keyframe: Keyframe | undefined): number {
  return keyframe ? keyframe.time + keyframe.hold : 0;
}
