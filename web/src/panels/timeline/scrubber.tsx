import { useRef } from "preact/hooks";
import type { LoopRange } from "../../playback/playback";
import { useStudio } from "../studio";
import { timeAt } from "./scale";
import type { Viewport } from "./viewport";

type ScrubState =
  | { readonly kind: "idle" }
  | { readonly kind: "scrubbing" }
  | { readonly kind: "ranging"; readonly from: number; readonly before: LoopRange | null };

/** Ranges shorter than this were a press, not a drag, seconds. */
const SHORTEST_RANGE = 0.1;

/** The ruler under the pointer: a drag scrubs; with Shift it marks the range that loops, and a Shift-press clears it. */
export function Scrubber({ viewport }: { viewport: Viewport }) {
  const { playback } = useStudio();
  const state = useRef<ScrubState>({ kind: "idle" });

  const timeOf = (event: PointerEvent & { readonly currentTarget: Element }) => {
    const time = timeAt(viewport.scale.peek(), viewport.trackX(event.clientX, event.currentTarget));
    return Math.min(playback.duration.peek(), Math.max(0, time));
  };

  return (
    <div
      class="scrubber"
      onPointerDown={(event) => {
        if (event.button !== 0 || !event.isPrimary) return;
        event.stopPropagation();
        event.currentTarget.setPointerCapture(event.pointerId);
        const time = timeOf(event);
        state.current = event.shiftKey
          ? { kind: "ranging", from: time, before: playback.range.peek() }
          : { kind: "scrubbing" };
        if (!event.shiftKey) playback.seek(time);
      }}
      onPointerMove={(event) => {
        const now = state.current;
        if (now.kind === "scrubbing") playback.seek(timeOf(event));
        if (now.kind !== "ranging") return;
        const time = timeOf(event);
        const range = { from: Math.min(now.from, time), to: Math.max(now.from, time) };
        playback.range.value = range.to - range.from < SHORTEST_RANGE ? null : range;
      }}
      onPointerUp={(event) => {
        const now = state.current;
        state.current = { kind: "idle" };
        if (now.kind !== "ranging") return;
        if (Math.abs(timeOf(event) - now.from) < SHORTEST_RANGE) playback.range.value = null;
        else playback.isLooping.value = true;
      }}
      onPointerCancel={() => {
        const now = state.current;
        state.current = { kind: "idle" };
        if (now.kind === "ranging") playback.range.value = now.before;
      }}
    />
  );
}
