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
  const segment = show.keyframeBefore(time);
  const share = show.progressAt(time);
  if (share !== null) {
    for (const agent of track.keyframes[segment]?.absent ?? []) out[agent] = smoothstep(0, FADE, share);
    for (const agent of track.keyframes[segment + 1]?.absent ?? []) out[agent] = smoothstep(0, FADE, 1 - share);
  }
  for (const agent of show.absentAt(time)) out[agent] = 0;
}

/**
 * How much of the trace of whoever is absent at both ends is to be seen at a share of the way, all of it while a formation
 * stands: it fades after the departure and comes again before the arrival, so that nothing vanishes at once.
 */
export function traceOfGone(share: number | null): number {
  return share === null ? 1 : 1 - smoothstep(0, FADE, Math.min(share, 1 - share));
}
