import { useRef } from "preact/hooks";
import { useShownAtPlayhead } from "../at-playhead";
import { useStudio } from "../studio";
import { countTicks, isWhole, PILL_ROOM, secondTicks, type Tick } from "./ruler";
import { xOf } from "./scale";
import type { Viewport } from "./viewport";

const TICKS_TOP = 12;
const BAR_LINES_TOP = 2;
const TICKS_BOTTOM = 17;
/** Labels step aside for a playhead that comes this much nearer, CSS pixels: not on every frame. */
const PLAYHEAD_STEP = 4;
/** A bar line is tall: its number stands beside it. */
const BAR_NUMBER_GAP = 4;

/** Seconds, or counts and bars, along the top of the track. Decoration: the slider "Time" says the same to a screen reader. */
export function RulerStrip({ viewport }: { viewport: Viewport }) {
  const { document, view } = useStudio();
  const labels = useRef<SVGGElement>(null);
  const { from, to } = viewport.drawn.value;
  const scale = viewport.scale.value;
  const { tempo } = document.scene.value;
  const ticks = view.ruler.value === "counts" ? countTicks(scale, tempo, from, to) : secondTicks(scale, from, to);
  const labelled = ticks.filter(({ label }) => label !== null);
  const stepAt = (time: number) => Math.round(xOf(viewport.scale.value, time) / PLAYHEAD_STEP);
  useShownAtPlayhead(stepAt, (step) => {
    const playhead = step * PLAYHEAD_STEP;
    const left = viewport.scroll.value;
    const right = left + viewport.width.value;
    labelled.forEach(({ x, isStrong }, k) => {
      const anchor = anchorOf(x, isStrong);
      const isAside = Math.abs(anchor - playhead) < PILL_ROOM || !isWhole(anchor, isStrong, left, right);
      labels.current?.children[k]?.classList.toggle("is-aside", isAside);
    });
  });

  return (
    <svg class="ruler number" width={viewport.trackWidth.value} height="20" aria-hidden="true">
      <path d={lines(ticks, false, TICKS_TOP)} />
      <path class="bar-lines" d={lines(ticks, true, BAR_LINES_TOP)} />
      <g ref={labels}>
        {labelled.map(({ x, isStrong, label }) => (
          <text key={label} x={anchorOf(x, isStrong)} y="9" class={isStrong ? "bar-number" : undefined}>
            {label}
          </text>
        ))}
      </g>
    </svg>
  );
}

function anchorOf(x: number, isStrong: boolean): number {
  return isStrong ? x + BAR_NUMBER_GAP : x;
}

function lines(ticks: readonly Tick[], areStrong: boolean, top: number): string {
  const shown = ticks.filter(({ isStrong }) => isStrong === areStrong);
  return shown.map(({ x }) => `M${Math.round(x) + 0.5} ${top}V${TICKS_BOTTOM}`).join("");
}
