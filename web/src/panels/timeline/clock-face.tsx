import { useComputed, useSignalEffect } from "@preact/signals";
import { useRef } from "preact/hooks";
import { barAndCount } from "../../document/counts";
import { formatTime } from "../../document/units";
import { useStudio } from "../studio";
import { shortTime } from "./clock";

/** The time, and bar and count where those are read: straight into the text while the show runs, a frame renders nothing. */
export function Clock() {
  const { document, playback, view } = useStudio();
  const now = useRef<HTMLSpanElement>(null);
  const bar = useRef<HTMLSpanElement>(null);
  const hasCounts = view.ruler.value === "counts";
  const text = useComputed(() => formatTime(playback.time.value));
  const count = useComputed(() => barAndCount(document.scene.value.tempo, playback.time.value));
  useSignalEffect(() => {
    if (now.current) now.current.textContent = text.value;
  });
  useSignalEffect(() => {
    const isRead = view.ruler.value === "counts";
    if (bar.current) bar.current.textContent = isRead ? count.value : "";
  });
  return (
    <span class="clock number">
      <span ref={bar} class="clock-count" title="Bar and count" hidden={!hasCounts} />
      <span ref={now} class="clock-now" /> <span class="unit">/ {shortTime(playback.duration.value)}</span>
    </span>
  );
}
