import { type ReadonlySignal, signal, untracked, useSignalEffect } from "@preact/signals";
import { useLayoutEffect, useMemo, useRef } from "preact/hooks";
import { useStudio } from "./studio";

/**
 * Shows what `read` makes of the time: after each rendering, when a signal that either reads has changed, and, while the
 * show runs, on frames on which it has become another. On all others nothing is rendered and nothing allocated.
 */
export function useShownAtPlayhead<Value>(read: (time: number) => Value, show: (value: Value) => void): void {
  const { playback } = useStudio();
  const latest = useRef({ read, show, shown: null as Value | null });
  latest.current.read = read;
  latest.current.show = show;
  const showNow = () => {
    const { current } = latest;
    current.shown = current.read(playback.time.peek());
    current.show(current.shown);
  };
  useLayoutEffect(() => untracked(showNow));
  useSignalEffect(() => {
    showNow();
    return playback.follow((time) => {
      const { current } = latest;
      const value = current.read(time);
      if (value === current.shown) return;
      current.shown = value;
      current.show(value);
    });
  });
}

/** What `read` makes of the time, as a signal: for what is rendered otherwise then. */
export function useAtPlayhead<Value>(read: (time: number) => Value): ReadonlySignal<Value> {
  const { playback } = useStudio();
  const value = useMemo(() => signal(untracked(() => read(playback.time.value))), [playback]);
  useShownAtPlayhead(read, (now) => {
    value.value = now;
  });
  return value;
}
