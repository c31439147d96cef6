/** Places sorted into square buckets of about one each, so that the nearest is found without looking at all. */
export class Buckets {
  private readonly columns: number;
  private readonly rows: number;
  /** Where each bucket begins in `items`; one more entry at the end. */
  private readonly starts: Uint32Array;
  private readonly items: Uint32Array;
  private readonly left: number;
  private readonly low: number;

  /**
   * @param xy x0, y0, x1, y1, … at least one place
   * @param size side of a bucket, > 0
   */
  constructor(
    private readonly xy: Float64Array,
    private readonly size: number,
  ) {
    let [left, low, right, high] = [Infinity, Infinity, -Infinity, -Infinity];
    for (let k = 0; k < xy.length; k += 2) {
      left = Math.min(left, xy[k] ?? 0);
      right = Math.max(right, xy[k] ?? 0);
      low = Math.min(low, xy[k + 1] ?? 0);
      high = Math.max(high, xy[k + 1] ?? 0);
    }
    this.left = left;
    this.low = low;
    this.columns = Math.floor((right - left) / size) + 1;
    this.rows = Math.floor((high - low) / size) + 1;
    this.starts = new Uint32Array(this.columns * this.rows + 1);
    this.items = new Uint32Array(xy.length / 2);
    this.sort();
  }

  /** The index of the place nearest to (x, y), the lowest on a tie. */
  nearest(x: number, y: number): number {
    const cx = Math.floor((x - this.left) / this.size);
    const cy = Math.floor((y - this.low) / this.size);
    const most = Math.max(cx, this.columns - 1 - cx, cy, this.rows - 1 - cy, 0);
    let best = 0;
    let least = Number.POSITIVE_INFINITY;
    // Rings of buckets outward: what a ring further out holds is at least (ring − 1) sides away.
    for (let ring = 0; ring <= most; ring += 1) {
      const reach = (ring - 1) * this.size;
      if (reach > 0 && reach * reach > least) break;
      for (let by = Math.max(0, cy - ring); by <= Math.min(this.rows - 1, cy + ring); by += 1) {
        const isEdge = by === cy - ring || by === cy + ring;
        const step = isEdge || ring === 0 ? 1 : 2 * ring;
        for (let bx = cx - ring; bx <= cx + ring; bx += step) {
          if (bx < 0 || bx >= this.columns) continue;
          const bucket = by * this.columns + bx;
          for (let at = this.starts[bucket] ?? 0; at < (this.starts[bucket + 1] ?? 0); at += 1) {
            const place = this.items[at] ?? 0;
            const dx = (this.xy[2 * place] ?? 0) - x;
            const dy = (this.xy[2 * place + 1] ?? 0) - y;
            const away = dx * dx + dy * dy;
            if (away < least || (away === least && place < best)) {
              least = away;
              best = place;
            }
          }
        }
      }
    }
    return best;
  }

  private sort(): void {
    const { xy, starts, items } = this;
    for (let k = 0; k < xy.length; k += 2) {
      const after = this.bucketOf(k) + 1;
      starts[after] = (starts[after] ?? 0) + 1;
    }
    for (let i = 1; i < starts.length; i += 1) starts[i] = (starts[i] ?? 0) + (starts[i - 1] ?? 0);
    const next = starts.slice();
    for (let k = 0; k < xy.length; k += 2) {
      const bucket = this.bucketOf(k);
      items[next[bucket] ?? 0] = k / 2;
      next[bucket] = (next[bucket] ?? 0) + 1;
    }
  }

  private bucketOf(k: number): number {
    const column = Math.floor(((this.xy[k] ?? 0) - this.left) / this.size);
    const row = Math.floor(((this.xy[k + 1] ?? 0) - this.low) / this.size);
    return row * this.columns + column;
  }
}
