/** Frames longer than this on average, seconds, mean that drawing does not keep up: 52 a second. */
const SLOW = 1 / 52;

/** How much the newest frame counts in the average. */
const WEIGHT = 0.15;

/** Whether playing keeps up with the screen; if not, what lies under the agents is drawn in turns. */
export interface Pace {
  /** Takes the seconds a frame took; 0 starts anew. */
  note(elapsed: number): void;
  readonly isSparing: boolean;
}

/** Spares from the moment that frames take longer than `slow` seconds until playing rests. */
export function createPace(slow = SLOW): Pace {
  // A number that a closure keeps is a new object whenever it changes.
  const average = new Float64Array(1);
  let isSparing = false;
  return {
    note(elapsed) {
      if (elapsed === 0) {
        average[0] = 0;
        isSparing = false;
        return;
      }
      const before = average[0] ?? 0;
      average[0] = before + (elapsed - before) * WEIGHT;
      if (average[0] > slow) isSparing = true;
    },
    get isSparing() {
      return isSparing;
    },
  };
}
