import { shortTime } from "./clock";
import { type Scale, timeAt, xOf } from "./scale";

export interface Tick {
  readonly x: number;
  /** Null for a tick between two labels. */
  readonly label: string | null;
}

/** Seconds between labels, and between the ticks below them. */
const STEPS: readonly (readonly [labels: number, ticks: number])[] = [
  [0.1, 0.1],
  [0.2, 0.1],
  [0.5, 0.1],
  [1, 0.25],
  [2, 0.5],
  [5, 1],
  [10, 2],
  [15, 5],
  [30, 5],
  [60, 15],
  [120, 30],
  [300, 60],
  [600, 120],
];

const LEAST_LABEL_GAP = 64;
/** Labels nearer than this to the playhead step aside for its pill. */
export const PILL_ROOM = 40;

/** The ticks of the part `from`–`to` of the track (CSS pixels), none before time 0. */
export function rulerTicks(scale: Scale, from: number, to: number): Tick[] {
  const [labels, ticks] = STEPS.find(([step]) => step * scale.pixelsPerSecond >= LEAST_LABEL_GAP) ?? [600, 120];
  const every = Math.round(labels / ticks);
  const first = Math.max(0, Math.ceil(timeAt(scale, from) / ticks));
  const last = Math.floor(timeAt(scale, to) / ticks);
  const found: Tick[] = [];
  for (let index = first; index <= last; index += 1) {
    // The product, not a running sum: a sum of tenths drifts, and a label would read 0:02.9.
    const time = index * ticks;
    found.push({ x: xOf(scale, time), label: index % every === 0 ? shortTime(time) : null });
  }
  return found;
}
