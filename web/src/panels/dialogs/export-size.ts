import { durationOf } from "../../document/limits";
import { mainTrack, type Scene } from "../../document/scene";

/** Characters of one row, by what real scenes take. */
const ROW_CHARACTERS = { keyframes: 34, csv: 53, json: 35 };

export interface ExportSize {
  readonly rows: number;
  readonly bytes: number;
}

/** Frames at the scene's frame rate, the first and the last included. */
export function frameCount(scene: Scene): number {
  return Math.floor(durationOf(scene) * scene.frameRate + 1e-9) + 1;
}

export function exportSize(scene: Scene, what: keyof typeof ROW_CHARACTERS): ExportSize {
  const { agents, keyframes } = mainTrack(scene);
  const rows = agents.length * (what === "keyframes" ? keyframes.length : frameCount(scene));
  return { rows, bytes: rows * ROW_CHARACTERS[what] };
}

/** `1.2 MB`, rounded for a person who decides whether to wait. */
export function bytesWords(bytes: number): string {
  if (bytes < 1000) return "under 1 kB";
  if (bytes < 1e6) return `about ${Math.round(bytes / 1000)} kB`;
  return `about ${(bytes / 1e6).toFixed(1)} MB`;
}
