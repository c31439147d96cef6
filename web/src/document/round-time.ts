/** Gestures in time are exact to a millisecond. */
export function roundTime(seconds: number): number {
  return Math.round(seconds * 1000) / 1000;
}

/** A time without the last bits a sum leaves; one that is finer than a millisecond stays as it is. */
export function tidyTime(time: number): number {
  const rounded = roundTime(time);
  return Math.abs(rounded - time) < 1e-9 ? rounded : time;
}
