import { useComputed, useSignalEffect } from "@preact/signals";
import { useRef } from "preact/hooks";
import { barAndCount } from "../../document/counts";
import { formatTime } from "../../document/units";
import { useStudio } from "../studio";
import { shortTime } from "./clock";
import { xOf } from "./scale";
import type { Viewport } from "./viewport";

const FINE_STEP = 0.1;
const COARSE_STEP = 1;

/** The line at the present and its pill, moved without rendering while the show runs. */
export function Playhead({ viewport }: { viewport: Viewport }) {
  const { document, playback, view } = useStudio();
  const head = useRef<HTMLDivElement>(null);
  const pill = useRef<HTMLSpanElement>(null);
  const text = useComputed(() => {
    const time = playback.time.value;
    return view.ruler.value === "counts" ? barAndCount(document.scene.value.tempo, time) : formatTime(time);
  });
  useSignalEffect(() => {
    const x = xOf(viewport.scale.value, playback.time.value);
    if (head.current) head.current.style.transform = `translateX(${x}px)`;
  });
  useSignalEffect(() => {
    if (pill.current) pill.current.textContent = text.value;
  });
  return (
    <div ref={head} class="playhead number" aria-hidden="true">
      <span ref={pill} />
    </div>
  );
}

/** The present as a slider, for the keyboard and for screen readers; the pointer has the ruler. */
export function TimeSlider() {
  const { playback } = useStudio();
  const slider = useRef<HTMLInputElement>(null);
  const text = useComputed(() => formatTime(playback.time.value));
  useSignalEffect(() => {
    if (!slider.current) return;
    slider.current.max = String(playback.duration.value);
    slider.current.value = String(playback.time.peek());
    slider.current.setAttribute("aria-valuetext", `${text.value} of ${shortTime(playback.duration.value)}`);
  });
  return (
    <input
      ref={slider}
      class="time-slider"
      type="range"
      aria-label="Time"
      min="0"
      step="any"
      onInput={(event) => playback.seek(Number(event.currentTarget.value))}
      onKeyDown={(event) => {
        const by = keyStep(event.key, event.shiftKey);
        if (by === 0) return;
        event.preventDefault();
        event.stopPropagation();
        playback.seek(playback.time.peek() + by);
      }}
    />
  );
}

function keyStep(key: string, isCoarse: boolean): number {
  const step = isCoarse ? COARSE_STEP : FINE_STEP;
  switch (key) {
    case "ArrowRight":
    case "ArrowUp":
      return step;
    case "ArrowLeft":
    case "ArrowDown":
      return -step;
    case "PageUp":
      return COARSE_STEP;
    case "PageDown":
      return -COARSE_STEP;
    default:
      return 0;
  }
}
