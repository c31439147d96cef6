/** The motion of one segment as it is drawn: samples at rising times, both ends included. */
export class SegmentMotion {
  /**
   * @param times scene seconds, one a sample, strictly ascending
   * @param xy x, y of agent 0 at sample 0, of agent 1 at sample 0, …, then sample 1
   * @param heights z of every agent, sample by sample; null in a plane scene
   */
  constructor(
    readonly times: Float64Array,
    readonly xy: Float32Array,
    readonly agentCount: number,
    readonly heights: Float32Array | null = null,
  ) {
    if (xy.length !== times.length * agentCount * 2) {
      throw new Error(`${times.length} samples of ${agentCount} agents are not ${xy.length} numbers`);
    }
  }

  get start(): number {
    return this.times[0] ?? 0;
  }

  get end(): number {
    return this.times[this.times.length - 1] ?? 0;
  }

  /** The last sample at or before `time`. */
  sampleBefore(time: number): number {
    let low = 0;
    let high = this.times.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if ((this.times[middle] ?? 0) <= time) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  /** Positions at `time`, straight between samples, into `out` (x, y an agent); allocates nothing. */
  positionsInto(time: number, out: Float32Array): void {
    this.sampledInto(this.xy, 2 * this.agentCount, time, out);
  }

  /** Heights at `time`, straight between samples, into `out`: 0 in a plane scene; allocates nothing. */
  heightsInto(time: number, out: Float32Array): void {
    if (this.heights) this.sampledInto(this.heights, this.agentCount, time, out);
    else out.fill(0);
  }

  private sampledInto(values: Float32Array, stride: number, time: number, out: Float32Array): void {
    const sample = this.sampleBefore(time);
    const next = Math.min(sample + 1, this.times.length - 1);
    const from = this.times[sample] ?? 0;
    const span = (this.times[next] ?? 0) - from;
    const t = span > 0 ? Math.min(1, Math.max(0, (time - from) / span)) : 0;
    const a = sample * stride;
    const b = next * stride;
    for (let k = 0; k < stride; k += 1) {
      const start = values[a + k] ?? 0;
      out[k] = start + ((values[b + k] ?? 0) - start) * t;
    }
  }
}
