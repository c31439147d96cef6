import { countsAt, timeOfCount } from "../../document/counts";
import type { Scene } from "../../document/scene";
import type { View } from "../../stage/view";

/** The lattice or the playhead draws a dragged time to it from this far, CSS pixels. */
const REACH = 6;
/** Seconds that a dragged time sticks to where seconds are read, unless they lie closer together than this. */
const LATTICE = 0.5;
const LEAST_GAP = 16;

/** What a dragged time sticks to besides the frames. */
export interface SnapTargets {
  readonly pixelsPerSecond: number;
  /** Scene seconds, e.g. the playhead. */
  readonly times: readonly number[];
  readonly ruler: ReturnType<View["ruler"]["peek"]>;
}

/**
 * Where a drag to `time` leads; scene seconds, never negative.
 *
 * The nearest target within reach, else where counts are read the nearest count, else the nearest frame.
 */
export function snapTime(time: number, scene: Pick<Scene, "tempo" | "frameRate">, targets: SnapTargets): number {
  const { pixelsPerSecond, times, ruler } = targets;
  const count = timeOfCount(scene.tempo, Math.round(countsAt(scene.tempo, time)));
  const half = Math.round(time / LATTICE) * LATTICE;
  const hasHalves = ruler === "seconds" && LATTICE * pixelsPerSecond >= LEAST_GAP;
  const reach = REACH / pixelsPerSecond;
  const nearest = (hasHalves ? [...times, half] : times)
    .filter((candidate) => candidate >= 0 && Math.abs(candidate - time) <= reach)
    .sort((a, b) => Math.abs(a - time) - Math.abs(b - time))[0];
  if (nearest !== undefined) return nearest;
  if (ruler === "counts" && count >= 0) return count;
  return Math.max(0, Math.round(time * scene.frameRate) / scene.frameRate);
}
