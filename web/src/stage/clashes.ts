/** Two agents that are too close, and how close. */
export interface Clash {
  a: number;
  b: number;
  /** Meters. */
  distance: number;
}

/** More clashes than this at once are a heap, not a list. */
const MOST = 64;

/** A distance rounded to single precision on the way here may fall short by this share of it. */
const ROUNDING = 1e-4;

/** Finds pairs nearer than a distance; keeps its buffers, so that looking every frame allocates nothing. */
export class ClashFinder {
  /** The clashes found last, `count` of them, worst first. */
  readonly found: readonly Clash[] = Array.from({ length: MOST }, () => ({ a: 0, b: 0, distance: 0 }));
  count = 0;
  private order = new Uint32Array(0);

  /**
   * Looks through `places` (x, y an agent, meters; heights beside them in space) for pairs nearer than `minimum` meters; who is marked as
   * gone is nobody's neighbor.
   */
  find(
    places: Float32Array,
    minimum: number,
    heights: Float32Array | null = null,
    isGone: Uint8Array | null = null,
  ): void {
    this.count = 0;
    const agentCount = places.length / 2;
    if (minimum <= 0 || agentCount < 2) return;
    this.sortByX(places, agentCount);
    const limit = minimum * (1 - ROUNDING);
    for (let rank = 0; rank < agentCount; rank += 1) {
      const a = this.order[rank] ?? 0;
      if (isGone?.[a]) continue;
      const x = places[2 * a] ?? 0;
      const y = places[2 * a + 1] ?? 0;
      for (let next = rank + 1; next < agentCount; next += 1) {
        const b = this.order[next] ?? 0;
        const dx = (places[2 * b] ?? 0) - x;
        if (dx >= limit) break;
        const dy = (places[2 * b + 1] ?? 0) - y;
        const dz = heights ? (heights[b] ?? 0) - (heights[a] ?? 0) : 0;
        const distance = Math.sqrt(dx * dx + dy * dy + dz * dz);
        if (distance < limit && !isGone?.[b]) this.keep(Math.min(a, b), Math.max(a, b), distance);
      }
    }
  }

  /** Insertion keeps the order of the last frame, which is nearly right. */
  private sortByX(places: Float32Array, agentCount: number): void {
    const { order } = this;
    if (order.length !== agentCount) {
      this.order = Uint32Array.from({ length: agentCount }, (_, agent) => agent).sort(
        (a, b) => (places[2 * a] ?? 0) - (places[2 * b] ?? 0),
      );
      return;
    }
    for (let rank = 1; rank < agentCount; rank += 1) {
      const agent = order[rank] ?? 0;
      const x = places[2 * agent] ?? 0;
      let to = rank;
      while (to > 0 && (places[2 * (order[to - 1] ?? 0)] ?? 0) > x) {
        order[to] = order[to - 1] ?? 0;
        to -= 1;
      }
      order[to] = agent;
    }
  }

  private keep(a: number, b: number, distance: number): void {
    let place = this.count;
    while (place > 0 && distance < (this.found[place - 1]?.distance ?? 0)) place -= 1;
    if (place >= MOST) return;
    if (this.count < MOST) this.count += 1;
    for (let k = this.count - 1; k > place; k -= 1) copy(this.found[k - 1], this.found[k]);
    const clash = this.found[place];
    if (clash) Object.assign(clash, { a, b, distance });
  }
}

function copy(from: Clash | undefined, to: Clash | undefined): void {
  if (!from || !to) return;
  to.a = from.a;
  to.b = from.b;
  to.distance = from.distance;
}
