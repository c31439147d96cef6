import { computed, signal } from "@preact/signals";
import type { RecordingData } from "../../engine/api";
import { Recording } from "../../engine/recording";
import { createPlayback } from "../../playback/playback";

/** A recording that was opened, and what was made of it; remembered until the page closes. */
export interface OpenRecording {
  /** As the file is called. */
  readonly name: string;
  readonly recording: Recording;
  /** Picked frames, ascending. */
  readonly picks: readonly number[];
  /** The frames that a scene was made of, the first of them its time 0; null until there is one. */
  readonly made: readonly number[] | null;
}

/** The recording at hand. */
export const opened = signal<OpenRecording | null>(null);

/** Its own playhead, seconds. */
export const recorded = createPlayback(computed(() => opened.value?.recording.duration ?? 0));

/** Whether somebody walks through it, and so looks at it and not at what was made from it. */
export const isWalked = signal(false);

/** Whether it is drawn beside the motion that was made from it. */
export const isOriginalShown = signal(true);

/** Puts another recording in the place of the one before. */
export function openRecording(name: string, { frameRate, agents, xy, notes }: RecordingData): void {
  const recording = new Recording(frameRate, agents, xy, notes);
  opened.value = { name, recording, picks: [], made: null };
  isWalked.value = true;
  recorded.pause();
  recorded.seek(0);
}

export function setPicks(picks: readonly number[]): void {
  const now = opened.peek();
  if (now) opened.value = { ...now, picks };
}
