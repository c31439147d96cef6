import { batch, computed, effect, type ReadonlySignal, type Signal, signal, untracked } from "@preact/signals";
import { advance, playedSpan, type Span, startFrom, within } from "./playhead";

/** Hears of the time, scene seconds. */
export type Follower = (time: number) => void;

/** A loop over part of the show, scene seconds. */
export type LoopRange = Span;

/** Where the show is. Time moves only by `tick`, so tests never wait. */
export interface Playback {
  /** Scene seconds. */
  readonly time: ReadonlySignal<number>;
  readonly duration: ReadonlySignal<number>;
  readonly isPlaying: ReadonlySignal<boolean>;
  readonly isLooping: Signal<boolean>;
  readonly range: Signal<LoopRange | null>;
  readonly speed: Signal<number>;
  play(): void;
  pause(): void;
  toggle(): void;
  seek(time: number): void;
  /** Advance by real seconds; called once a frame while playing, outside of effects. */
  tick(elapsed: number): void;
  /** Tells `follower` the time whenever it has changed. A frame allocates nothing for it, as it does for an effect. Answers how to stop. */
  follow(follower: Follower): () => void;
}

/** A playhead at the beginning of a show of `duration` seconds; a show that gets shorter takes it along. */
export function createPlayback(duration: ReadonlySignal<number>): Playback {
  const time = signal(0);
  const isPlaying = signal(false);
  const isLooping = signal(false);
  const range = signal<LoopRange | null>(null);
  const speed = signal(1);

  /** A range is a loop's: without one the show plays to its end. */
  const span = computed(() => playedSpan(isLooping.value ? range.value : null, duration.value));
  let followers: readonly Follower[] = [];

  effect(() => {
    if (time.peek() > duration.value) moveTo(duration.value);
  });

  function moveTo(next: number): void {
    time.value = next;
    untracked(tell);
  }

  function tell(): void {
    // Who stops following meanwhile leaves this list as it is.
    const told = followers;
    for (let k = 0; k < told.length; k += 1) told[k]?.(time.value);
  }

  function play(): void {
    if (duration.peek() <= 0) return;
    batch(() => {
      moveTo(startFrom(time.peek(), span.peek(), isLooping.peek()));
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
      moveTo(within(to, { from: 0, to: duration.peek() }));
    },
    tick(elapsed) {
      if (!isPlaying.value) return;
      const played = span.value;
      const next = advance(time.value, elapsed * speed.value, played, isLooping.value);
      moveTo(next);
      if (next >= played.to) isPlaying.value = false;
    },
    follow(follower) {
      followers = [...followers, follower];
      return () => {
        followers = followers.filter((other) => other !== follower);
      };
    },
  };
}
