import { signal } from "@preact/signals";
import type { Formation } from "../../document/formation";
import type { ModeBasis } from "../../engine/modes";

/** What is drawn over the stage while the modes are looked at: of those who stand there alone, each by its place in `agents`. */
export interface ModesPicture {
  /** Their numbers in the scene. */
  readonly agents: readonly number[];
  readonly formation: Formation;
  /** a0, b0, a1, b1, …; empty while they are not known. */
  readonly pairs: Uint32Array;
  readonly basis: ModeBasis;
  /** The formation is put together from so many modes; the last of them is the one looked at. */
  readonly count: number;
}

/** Set by the panel, drawn by the stage's overlay; null while there is nothing to see. */
export const picture = signal<ModesPicture | null>(null);
