import type { Scene } from "./scene";

export type Tempo = Scene["tempo"];

/**
 * This near its beginning a count has begun, in counts: times are kept to the millisecond, which at 400 counts a minute
 * leaves them 0.0033 off.
 */
const ON_COUNT = 0.005;

export function secondsPerCount(tempo: Tempo): number {
  return 60 / tempo.beatsPerMinute;
}

/** Counts since the first one; negative before it. */
export function countsAt(tempo: Tempo, time: number): number {
  return (time - tempo.start) / secondsPerCount(tempo);
}

/** The time of a count, 0 the first; scene seconds. */
export function timeOfCount(tempo: Tempo, count: number): number {
  return tempo.start + count * secondsPerCount(tempo);
}

/** `5.3`: the third count of bar 5. Bar 1 begins with the first count; what comes before is bar 0, −1, … */
export function barAndCount(tempo: Tempo, time: number): string {
  return formatCounts(tempo, countBegun(tempo, time));
}

/** The last count that has begun, 0 the first. */
export function countBegun(tempo: Tempo, time: number): number {
  return Math.floor(countsAt(tempo, time) + ON_COUNT);
}

export function formatCounts(tempo: Tempo, count: number): string {
  const bar = Math.floor(count / tempo.beatsPerBar);
  return `${barNumber(bar)}.${count - bar * tempo.beatsPerBar + 1}`;
}

/** What the bar with this index is called, 0 the first. */
export function barNumber(bar: number): string {
  return bar < -1 ? `−${-1 - bar}` : String(bar + 1);
}
