import type { ReadonlySignal, Signal } from "@preact/signals";

/** A loop over part of the show, scene seconds. */
export interface LoopRange {
  readonly from: number;
  readonly to: number;
}

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
