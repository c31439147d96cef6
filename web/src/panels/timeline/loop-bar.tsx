import type { LoopRange } from "../../playback/playback";
import { useStudio } from "../studio";
import { shortTime } from "./clock";
import { placed } from "./place";
import { timeAt, xOf } from "./scale";
import type { Viewport } from "./viewport";

const SHORTEST_RANGE = 0.1;

/** The part of the show that loops, with an end to pull at each side; Delete on an end clears it. */
export function LoopBar({ viewport }: { viewport: Viewport }) {
  const { playback } = useStudio();
  const range = playback.range.value;
  if (!range) return null;
  const scale = viewport.scale.value;
  const from = xOf(scale, range.from);
  const to = xOf(scale, range.to);
  const most = playback.duration.value;
  return (
    <div class={playback.isLooping.value ? "loop-bar" : "loop-bar is-off"}>
      <i ref={placed(from, to - from)} class="loop-range" />
      <End
        label="Loop start"
        viewport={viewport}
        time={range.from}
        least={0}
        most={range.to - SHORTEST_RANGE}
        change={(time) => ({ ...range, from: time })}
      />
      <End
        label="Loop end"
        viewport={viewport}
        time={range.to}
        least={range.from + SHORTEST_RANGE}
        most={most}
        change={(time) => ({ ...range, to: time })}
      />
    </div>
  );
}

interface EndProps {
  readonly label: string;
  readonly viewport: Viewport;
  readonly time: number;
  readonly least: number;
  readonly most: number;
  change(time: number): LoopRange;
}

function End({ label, viewport, time, least, most, change }: EndProps) {
  const { playback } = useStudio();
  const move = (to: number) => {
    playback.range.value = change(Math.max(least, Math.min(most, to)));
  };
  return (
    <div
      ref={placed(xOf(viewport.scale.value, time))}
      class="loop-end"
      role="slider"
      tabIndex={0}
      aria-label={label}
      aria-valuemin={least}
      aria-valuemax={most}
      aria-valuenow={Math.round(time * 100) / 100}
      aria-valuetext={shortTime(time)}
      onPointerDown={(event) => {
        event.stopPropagation();
        event.currentTarget.setPointerCapture(event.pointerId);
      }}
      onPointerMove={(event) => {
        if (!event.currentTarget.hasPointerCapture(event.pointerId)) return;
        move(timeAt(viewport.scale.peek(), viewport.trackX(event.clientX, event.currentTarget)));
      }}
      onKeyDown={(event) => {
        const step = event.shiftKey ? 1 : 0.1;
        if (event.key === "ArrowRight") move(time + step);
        else if (event.key === "ArrowLeft") move(time - step);
        else if (event.key === "Delete" || event.key === "Backspace") playback.range.value = null;
        else return;
        event.preventDefault();
        event.stopPropagation();
      }}
    />
  );
}
