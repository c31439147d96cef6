import { useComputed, useSignalEffect } from "@preact/signals";
import { useRef } from "preact/hooks";
import { formatTime } from "../../document/units";
import { useStudio } from "../studio";
import { shortTime } from "./clock";

/** The time, written straight into the text while the show runs: a frame renders nothing. */
export function Clock() {
  const { playback } = useStudio();
  const now = useRef<HTMLSpanElement>(null);
  const text = useComputed(() => formatTime(playback.time.value));
  useSignalEffect(() => {
    if (now.current) now.current.textContent = text.value;
  });
  return (
    <span class="clock number">
      <span ref={now} class="clock-now" /> <span class="unit">/ {shortTime(playback.duration.value)}</span>
    </span>
  );
}
