import { barAndCount, barNumber, countsAt, secondsPerCount, type Tempo, timeOfCount } from "../../document/counts";
import { shortTime } from "./clock";
import { type Scale, timeAt, xOf } from "./scale";

export interface Tick {
  readonly x: number;
  /** A bar line, where counts are read. */
  readonly isStrong: boolean;
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

/** How far a label of seconds reaches to either side of its tick, and a bar's number to the right of its line: CSS pixels. */
const LABEL_REACH = 15;
const NUMBER_REACH = 26;

/** Whether the window's edges `from` and `to` leave a label whole; `x` is where it is anchored, all CSS pixels of the track. */
export function isWhole(x: number, isStrong: boolean, from: number, to: number): boolean {
  return x - (isStrong ? 0 : LABEL_REACH) >= from && x + (isStrong ? NUMBER_REACH : LABEL_REACH) <= to;
}

/** Bars between labels, and between bar lines. */
const BAR_STEPS: readonly (readonly [labels: number, lines: number])[] = [
  [1, 1],
  [2, 1],
  [4, 1],
  [8, 2],
  [16, 4],
  [32, 8],
  [64, 16],
  [128, 32],
];

/** Counts closer together than this are left out, bar lines stay; CSS pixels. */
const LEAST_COUNT_GAP = 5;

/** The ticks of the part `from`–`to` of the track (CSS pixels), none before time 0: seconds. */
export function secondTicks(scale: Scale, from: number, to: number): Tick[] {
  const [labels, ticks] = STEPS.find(([step]) => step * scale.pixelsPerSecond >= LEAST_LABEL_GAP) ?? [600, 120];
  const every = Math.round(labels / ticks);
  const first = Math.max(0, Math.ceil(timeAt(scale, from) / ticks));
  const last = Math.floor(timeAt(scale, to) / ticks);
  const found: Tick[] = [];
  for (let index = first; index <= last; index += 1) {
    // The product, not a running sum: a sum of tenths drifts, and a label would read 0:02.9.
    const time = index * ticks;
    found.push({ x: xOf(scale, time), isStrong: false, label: index % every === 0 ? shortTime(time) : null });
  }
  return found;
}

/** The same as counts and bars: bar lines stand out and are numbered; counts have numbers where there is room. */
export function countTicks(scale: Scale, tempo: Tempo, from: number, to: number): Tick[] {
  const countGap = secondsPerCount(tempo) * scale.pixelsPerSecond;
  const barGap = countGap * tempo.beatsPerBar;
  const [labels, lines] = BAR_STEPS.find(([step]) => step * barGap >= LEAST_LABEL_GAP) ?? [256, 64];
  const step = lines === 1 && countGap >= LEAST_COUNT_GAP ? 1 : lines * tempo.beatsPerBar;
  const hasCountLabels = countGap >= LEAST_LABEL_GAP;
  const first = Math.ceil(countsAt(tempo, Math.max(0, timeAt(scale, from))) / step - 1e-9) * step;
  const last = Math.floor(countsAt(tempo, timeAt(scale, to)) + 1e-9);
  const found: Tick[] = [];
  for (let count = first; count <= last; count += step) {
    const bar = count / tempo.beatsPerBar;
    const isStrong = Number.isInteger(bar);
    const time = timeOfCount(tempo, count);
    const isNumbered = isStrong && bar % labels === 0;
    const label = isNumbered ? barNumber(bar) : hasCountLabels ? barAndCount(tempo, time) : null;
    found.push({ x: xOf(scale, time), isStrong, label });
  }
  return found;
}
