import { useLayoutEffect, useRef } from "preact/hooks";
import { countBegun, formatCounts } from "../../document/counts";
import { formatTenths, tenthsAt } from "../../document/units";
import { useShownAtPlayhead } from "../at-playhead";
import { useStudio } from "../studio";
import { shortTime } from "./clock";
import { xOf } from "./scale";
import type { Viewport } from "./viewport";

const FINE_STEP = 0.1;
const COARSE_STEP = 1;

/** No track is longer, CSS pixels. */
const FARTHEST = 1e7;

/**
 * The line at the present and its pill, moved without rendering while the show runs.
 *
 * A millisecond of its standing animation is a pixel of the track: a frame sets a number, where a style would be a new text.
 */
export function Playhead({ viewport }: { viewport: Viewport }) {
  const { document, view } = useStudio();
  const head = useRef<HTMLDivElement>(null);
  const pill = useRef<HTMLSpanElement>(null);
  const way = useRef<Animation | null>(null);
  useLayoutEffect(() => {
    const animation = head.current?.animate({ transform: ["none", `translateX(${FARTHEST}px)`] }, FARTHEST);
    animation?.pause();
    way.current = animation ?? null;
    return () => animation?.cancel();
  }, []);
  useShownAtPlayhead(
    (time) => xOf(viewport.scale.value, time),
    (x) => {
      if (way.current) way.current.currentTime = x;
    },
  );
  const hasCounts = () => view.ruler.value === "counts";
  useShownAtPlayhead(
    (time) => (hasCounts() ? countBegun(document.scene.value.tempo, time) : tenthsAt(time)),
    (now) => {
      if (!pill.current) return;
      pill.current.textContent = hasCounts() ? formatCounts(document.scene.value.tempo, now) : formatTenths(now);
    },
  );
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
  useShownAtPlayhead(tenthsAt, (tenths) => {
    if (!slider.current) return;
    slider.current.max = String(playback.duration.value);
    slider.current.value = String(playback.time.peek());
    slider.current.setAttribute("aria-valuetext", `${formatTenths(tenths)} of ${shortTime(playback.duration.value)}`);
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
