import type { Point } from "../document/formation";

/** A rectangle of ground, meters. */
export interface Area {
  readonly minX: number;
  readonly minY: number;
  readonly maxX: number;
  readonly maxY: number;
}

/** A motion that was recorded elsewhere: where everybody was in every frame, or was not. */
export class Recording {
  readonly agentCount: number;
  readonly frameCount: number;
  #bounds: Area | null = null;

  /**
   * @param frameRate frames a second
   * @param names by agent, as the file calls them
   * @param xy meters: x, y of every agent, frame by frame; NaN while an agent is absent
   * @param notes what was made of the file that it does not say itself
   */
  constructor(
    readonly frameRate: number,
    readonly names: readonly string[],
    private readonly xy: Float32Array,
    readonly notes: readonly string[],
  ) {
    this.agentCount = names.length;
    this.frameCount = names.length === 0 ? 0 : xy.length / (2 * names.length);
    if (!Number.isInteger(this.frameCount)) throw new Error(`${xy.length} numbers are no frames of ${names.length}`);
  }

  /** Seconds from the first frame to the last. */
  get duration(): number {
    return this.timeOf(Math.max(0, this.frameCount - 1));
  }

  timeOf(frame: number): number {
    return frame / this.frameRate;
  }

  /** The frame nearest to a time. */
  frameAt(time: number): number {
    return Math.min(this.frameCount - 1, Math.max(0, Math.round(time * this.frameRate)));
  }

  isPresent(frame: number, agent: number): boolean {
    return !Number.isNaN(this.xy[2 * (frame * this.agentCount + agent)] ?? Number.NaN);
  }

  /** Not a number while the agent is absent. */
  place(frame: number, agent: number): Point {
    const at = 2 * (frame * this.agentCount + agent);
    return [this.xy[at] ?? Number.NaN, this.xy[at + 1] ?? Number.NaN];
  }

  /** The smallest rectangle around everybody at any time; null when nobody ever is there. Found once. */
  bounds(): Area | null {
    this.#bounds ??= this.#findBounds();
    return this.#bounds.maxX >= this.#bounds.minX ? this.#bounds : null;
  }

  #findBounds(): Area {
    let [minX, minY, maxX, maxY] = [Infinity, Infinity, -Infinity, -Infinity];
    for (let k = 0; k + 1 < this.xy.length; k += 2) {
      const [x, y] = [this.xy[k] ?? Number.NaN, this.xy[k + 1] ?? Number.NaN];
      // Comparisons with what is no number are false.
      if (x < minX) minX = x;
      if (x > maxX) maxX = x;
      if (y < minY) minY = y;
      if (y > maxY) maxY = y;
    }
    return { minX, minY, maxX, maxY };
  }
}
