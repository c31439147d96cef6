import { useSignalEffect } from "@preact/signals";
import { useLayoutEffect, useRef } from "preact/hooks";
import { useStudio } from "../studio";
import { PILL_ROOM, rulerTicks } from "./ruler";
import { xOf } from "./scale";
import type { Viewport } from "./viewport";

const TICKS_TOP = 12;
const TICKS_BOTTOM = 17;

/** Seconds along the top of the track. Decoration: the slider "Time" says the same to a screen reader. */
export function RulerStrip({ viewport }: { viewport: Viewport }) {
  const { playback } = useStudio();
  const labels = useRef<SVGGElement>(null);
  const { from, to } = viewport.drawn.value;
  const ticks = rulerTicks(viewport.scale.value, from, to);

  const makeRoom = () => {
    const playhead = xOf(viewport.scale.value, playback.time.value);
    for (const label of labels.current?.children ?? []) {
      const isNear = Math.abs(Number(label.getAttribute("x")) - playhead) < PILL_ROOM;
      if (label.classList.contains("is-aside") !== isNear) label.classList.toggle("is-aside", isNear);
    }
  };
  useSignalEffect(makeRoom);
  // Labels that this rendering brought have not heard of the playhead yet.
  useLayoutEffect(makeRoom);

  return (
    <svg class="ruler number" width={viewport.trackWidth.value} height="20" aria-hidden="true">
      <path d={ticks.map(({ x }) => `M${Math.round(x) + 0.5} ${TICKS_TOP}V${TICKS_BOTTOM}`).join("")} />
      <g ref={labels}>
        {ticks.map(({ x, label }) =>
          label === null ? null : (
            <text key={label} x={x} y="9">
              {label}
            </text>
          ),
        )}
      </g>
    </svg>
  );
}
