import { batch, effect, type ReadonlySignal, type Signal, signal } from "@preact/signals";
import { advance, playedSpan, type Span, startFrom, within } from "./playhead";

/** A loop over part of the show, scene seconds. */
export type LoopRange = Span;

/** Where the show is. Time moves only by `tick`, so tests never wait. */
export interface Playback {
  /** Scene seconds. */
  readonly time: Signal<number>;
  readonly duration: ReadonlySignal<number>;
  readonly isPlaying: ReadonlySignal<boolean>;
  readonly isLooping: Signal<boolean>;
  readonly range: Signal<LoopRange | null>;
  readonly speed: Signal<number>;
  play(): void;
  pause(): void;
  toggle(): void;
  seek(time: number): void;
  /** Advance by real seconds; called once a frame while playing. */
  tick(elapsed: number): void;
}

/** A playhead at the beginning of a show of `duration` seconds; a show that gets shorter takes it along. */
export function createPlayback(duration: ReadonlySignal<number>): Playback {
  const time = signal(0);
  const isPlaying = signal(false);
  const isLooping = signal(false);
  const range = signal<LoopRange | null>(null);
  const speed = signal(1);

  /** A range is a loop's: without one the show plays to its end. */
  const span = (): Span => playedSpan(isLooping.peek() ? range.peek() : null, duration.peek());

  effect(() => {
    if (time.peek() > duration.value) time.value = duration.value;
  });

  function play(): void {
    if (duration.peek() <= 0) return;
    batch(() => {
      time.value = startFrom(time.peek(), span(), isLooping.peek());
      isPlaying.value = true;
    });
  }

  function pause(): void {
    isPlaying.value = false;
  }

  return {
    time,
    duration,
    isPlaying,
    isLooping,
    range,
    speed,
    play,
    pause,
    toggle: () => (isPlaying.peek() ? pause() : play()),
    seek(to) {
      time.value = within(to, { from: 0, to: duration.peek() });
    },
    tick(elapsed) {
      if (!isPlaying.peek()) return;
      const next = advance(time.peek(), elapsed * speed.peek(), span(), isLooping.peek());
      batch(() => {
        time.value = next.time;
        isPlaying.value = next.isPlaying;
      });
    },
  };
}
