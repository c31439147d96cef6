import type { Scene } from "../../document/scene";

/** A beat or the playhead draws a dragged time to it from this far, CSS pixels. */
const REACH = 6;
/** Beats closer together than this would leave no place between them. */
const LEAST_BEAT_GAP = 16;

/** What a dragged time sticks to besides the frames. */
export interface SnapTargets {
  readonly pixelsPerSecond: number;
  /** Scene seconds, e.g. the playhead. */
  readonly times: readonly number[];
}

/** The nearest beat or target within reach, else the nearest frame; scene seconds, never negative. */
export function snapTime(time: number, scene: Pick<Scene, "tempo" | "frameRate">, targets: SnapTargets): number {
  const beat = 60 / scene.tempo.beatsPerMinute;
  const candidates = [...targets.times];
  if (beat * targets.pixelsPerSecond >= LEAST_BEAT_GAP) {
    candidates.push(scene.tempo.start + Math.round((time - scene.tempo.start) / beat) * beat);
  }
  const reach = REACH / targets.pixelsPerSecond;
  const nearest = candidates
    .filter((candidate) => candidate >= 0 && Math.abs(candidate - time) <= reach)
    .sort((a, b) => Math.abs(a - time) - Math.abs(b - time))[0];
  return nearest ?? Math.max(0, Math.round(time * scene.frameRate) / scene.frameRate);
}
