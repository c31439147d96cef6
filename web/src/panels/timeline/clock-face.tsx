import { useRef } from "preact/hooks";
import { countBegun, formatCounts } from "../../document/counts";
import { formatTenths, tenthsAt } from "../../document/units";
import { useShownAtPlayhead } from "../at-playhead";
import { useStudio } from "../studio";
import { shortTime } from "./clock";

/** The time, and bar and count where those are read: straight into the text while the show runs, a frame renders nothing. */
export function Clock() {
  const { document, playback, view } = useStudio();
  const now = useRef<HTMLSpanElement>(null);
  const bar = useRef<HTMLSpanElement>(null);
  const hasCounts = view.ruler.value === "counts";
  useShownAtPlayhead(tenthsAt, (tenths) => {
    if (now.current) now.current.textContent = formatTenths(tenths);
  });
  useShownAtPlayhead(
    (time) => (view.ruler.value === "counts" ? countBegun(document.scene.value.tempo, time) : null),
    (count) => {
      if (bar.current) bar.current.textContent = count === null ? "" : formatCounts(document.scene.value.tempo, count);
    },
  );
  return (
    <span class="clock number">
      <span ref={bar} class="clock-count" title="Bar and count" hidden={!hasCounts} />
      <span ref={now} class="clock-now" /> <span class="unit">/ {shortTime(playback.duration.value)}</span>
    </span>
  );
}
