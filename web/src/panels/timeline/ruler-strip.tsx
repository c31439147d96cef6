import { useSignalEffect } from "@preact/signals";
import { useLayoutEffect, useRef } from "preact/hooks";
import { useStudio } from "../studio";
import { countTicks, isWhole, PILL_ROOM, secondTicks, type Tick } from "./ruler";
import { xOf } from "./scale";
import type { Viewport } from "./viewport";

const TICKS_TOP = 12;
const BAR_LINES_TOP = 2;
const TICKS_BOTTOM = 17;
/** A bar line is tall: its number stands beside it. */
const BAR_NUMBER_GAP = 4;

/** Seconds, or counts and bars, along the top of the track. Decoration: the slider "Time" says the same to a screen reader. */
export function RulerStrip({ viewport }: { viewport: Viewport }) {
  const { document, playback, view } = useStudio();
  const labels = useRef<SVGGElement>(null);
  const { from, to } = viewport.drawn.value;
  const scale = viewport.scale.value;
  const { tempo } = document.scene.value;
  const ticks = view.ruler.value === "counts" ? countTicks(scale, tempo, from, to) : secondTicks(scale, from, to);

  const makeRoom = () => {
    const playhead = xOf(viewport.scale.value, playback.time.value);
    const left = viewport.scroll.value;
    const right = left + viewport.width.value;
    for (const label of labels.current?.children ?? []) {
      const x = Number(label.getAttribute("x"));
      const isStrong = label.classList.contains("bar-number");
      const isAside = Math.abs(x - playhead) < PILL_ROOM || !isWhole(x, isStrong, left, right);
      if (label.classList.contains("is-aside") !== isAside) label.classList.toggle("is-aside", isAside);
    }
  };
  useSignalEffect(makeRoom);
  // Labels that this rendering brought have not heard of the playhead yet.
  useLayoutEffect(makeRoom);

  return (
    <svg class="ruler number" width={viewport.trackWidth.value} height="20" aria-hidden="true">
      <path d={lines(ticks, false, TICKS_TOP)} />
      <path class="bar-lines" d={lines(ticks, true, BAR_LINES_TOP)} />
      <g ref={labels}>
        {ticks.map(({ x, isStrong, label }) =>
          label === null ? null : (
            <text key={label} x={isStrong ? x + BAR_NUMBER_GAP : x} y="9" class={isStrong ? "bar-number" : undefined}>
              {label}
            </text>
          ),
        )}
      </g>
    </svg>
  );
}

function lines(ticks: readonly Tick[], areStrong: boolean, top: number): string {
  const shown = ticks.filter(({ isStrong }) => isStrong === areStrong);
  return shown.map(({ x }) => `M${Math.round(x) + 0.5} ${top}V${TICKS_BOTTOM}`).join("");
}
