import { presentAt, walkersOf } from "../document/absence";
import { mainTrack, type Scene } from "../document/scene";
import type { Solo } from "./solo";

/** The eigenbasis of those who stand in a keyframe, as far as it is shown. Mode 0 is the constant one, which is not stored. */
export class ModeBasis {
  readonly agentCount: number;
  /** Modes that are there, the constant one included. */
  readonly shownCount: number;

  /**
   * @param eigenvalues of all modes, ascending, 1/m; the constant mode's 0 first
   * @param entries of mode 1 an entry an agent, then of mode 2, …
   */
  constructor(
    readonly eigenvalues: Float64Array,
    private readonly entries: Float64Array,
  ) {
    this.agentCount = eigenvalues.length;
    this.shownCount = this.agentCount === 0 ? 0 : 1 + entries.length / this.agentCount;
  }

  /** A unit mode, an entry an agent. */
  mode(index: number): Float64Array {
    const { agentCount } = this;
    if (index === 0) return new Float64Array(agentCount).fill(1 / Math.sqrt(agentCount));
    return this.entries.subarray((index - 1) * agentCount, index * agentCount);
  }
}

/** The orders that a match compares, as the engine lists them. */
export const MATCH_ORDERS = ["eigenvalue", "greedy", "maxmin", "hungarian"] as const;

/** How alike the modes at both ends of a transition are; the constant ones are left out. */
export class ModeMatch {
  /** How many modes of the source are shown. */
  readonly shownCount: number;

  /**
   * @param modeCount modes at each end
   * @param numbers a row of |inner products| a source mode, then the target mode of each, an order at a time
   */
  constructor(
    private readonly modeCount: number,
    private readonly numbers: Float32Array,
  ) {
    this.shownCount = modeCount === 0 ? 0 : numbers.length / (modeCount + MATCH_ORDERS.length);
  }

  /** The target mode that `order` pairs with each source mode shown. */
  targets(order: number): Float32Array {
    const start = this.shownCount * (this.modeCount + order);
    return this.numbers.subarray(start, start + this.shownCount);
  }

  /** 0..1: how alike a source and a target mode are, whatever their signs. */
  amount(source: number, target: number): number {
    return this.numbers[source * this.modeCount + target] ?? 0;
  }
}

/** Modes of a keyframe, `most` beside the constant one. */
export async function askModes(solo: Solo, scene: Scene, keyframe: number, most: number): Promise<ModeBasis> {
  const numbers = await solo.ask("modes", (link) => ({ scene: link.ledger.message(scene), keyframe, most }));
  const agentCount = presentAt(mainTrack(scene), keyframe).length;
  return new ModeBasis(numbers.subarray(0, agentCount), numbers.subarray(agentCount));
}

/** What a transition's modes have in common, and their eigenvalues on the way. */
export interface ModesBetween {
  readonly match: ModeMatch;
  /** All eigenvalues, ascending, at t = 0, 1/steps, …, 1; empty for 0 steps. */
  readonly eigenvalues: Float64Array;
  /** How many there are at each instant: one for everybody on the way. */
  readonly modeCount: number;
}

export async function askModesBetween(
  solo: Solo,
  scene: Scene,
  segment: number,
  { most, steps }: { readonly most: number; readonly steps: number },
): Promise<ModesBetween> {
  const { match, eigenvalues } = await solo.ask("modesBetween", (link) => ({
    scene: link.ledger.message(scene),
    segment,
    most,
    steps,
  }));
  const modeCount = walkersOf(mainTrack(scene), segment).length;
  return { match: new ModeMatch(Math.max(0, modeCount - 1), match), eigenvalues, modeCount };
}
