import type { Spread } from "../document/commands/spread-out";
import { Formation } from "../document/formation";
import type { Scene } from "../document/scene";
import type { Approach, Extreme } from "./api";
import type { Solo } from "./solo";

/** What a transition comes to when those who are stuck in it spread out; meters, meters a second. */
export interface SalvageReport {
  readonly clearance: Approach | null;
  /** From where the method has them. */
  readonly deviation: Extreme;
  readonly topSpeed: number;
  /** Of the method's own motion. */
  readonly guideTopSpeed: number;
  /** Too far from it or too much faster to be taken without a second look. */
  readonly isWild: boolean;
  /** Meetings that are still too near. */
  readonly unsolved: readonly Approach[];
}

/** Keyframes that keep everybody apart, none where nothing does, and the numbers. */
export interface Salvage extends Spread {
  readonly report: SalvageReport;
}

/** Looks for a way to let them spread out; null where there is nothing to mend. Ending `solo` cancels. */
export async function askSalvage(
  solo: Solo,
  scene: Scene,
  segment: number,
  onProgress: (progress: number) => void,
): Promise<Salvage | null> {
  let answer = await solo.ask("salvage", (link) => ({ scene: link.ledger.message(scene), segment }));
  while (answer.found === null) {
    onProgress(answer.progress);
    answer = await solo.ask("salvage", () => ({ scene: null, segment }));
  }
  return salvageFrom(answer.found);
}

interface SalvageText {
  keyframes: { positions: { xy: number[]; heights: number[] | null } | Formation }[];
}

/** From the engine's own text. */
function salvageFrom(text: string): Salvage | null {
  const found = JSON.parse(text) as SalvageText | null;
  for (const keyframe of found?.keyframes ?? []) {
    const { xy, heights } = keyframe.positions;
    keyframe.positions = new Formation(Float64Array.from(xy), heights && Float64Array.from(heights));
  }
  return found as unknown as Salvage | null;
}
