import type { Track } from "../document/scene";
import type { Show } from "../playback/show";
import { smoothstep } from "./spacing";

/** Who comes is wholly there after this share of the way, and who leaves until as much before its end. */
const FADE = 0.5;

/**
 * How much of everybody is to be seen at `time`, 0 nothing to 1 all, into `out`: who leaves fades toward the arrival, who
 * comes appears after the departure. Allocates nothing.
 */
export function presenceInto(out: Float32Array, track: Track, show: Show, time: number): void {
  out.fill(1);
  const segment = show.segmentAt(time);
  if (segment !== null) {
    const start = show.startOf(segment);
    const share = (time - start) / (show.endOf(segment) - start);
    for (const agent of track.keyframes[segment]?.absent ?? []) out[agent] = smoothstep(0, FADE, share);
    for (const agent of track.keyframes[segment + 1]?.absent ?? []) out[agent] = smoothstep(0, FADE, 1 - share);
  }
  for (const agent of show.absentAt(time)) out[agent] = 0;
}
