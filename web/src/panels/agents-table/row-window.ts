import type { TableRow } from "./table-rows";

/** Heights of the two kinds of row, CSS pixels. */
export interface RowHeights {
  readonly heading: number;
  readonly agent: number;
}

/** A row to draw, or the room that rows out of sight take. */
export type Drawn =
  | { readonly kind: "row"; readonly index: number }
  | { readonly kind: "gap"; readonly height: number };

/** Where each row begins, and after the last, where all end. */
export function rowOffsets(rows: readonly TableRow[], heights: RowHeights): Float64Array {
  const offsets = new Float64Array(rows.length + 1);
  rows.forEach((row, index) => {
    offsets[index + 1] = (offsets[index] ?? 0) + heights[row.kind];
  });
  return offsets;
}

/** The row at a height. */
export function rowAt(offsets: Float64Array, y: number): number {
  let low = 0;
  let high = Math.max(0, offsets.length - 2);
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if ((offsets[middle] ?? 0) <= y) low = middle;
    else high = middle - 1;
  }
  return low;
}

/**
 * The rows in sight with some beyond, and gaps for the rest; together as high as all rows.
 *
 * @param kept a row that stays although it is out of sight: it has the focus
 */
export function drawnRows(offsets: Float64Array, top: number, height: number, kept: number | null): Drawn[] {
  const count = offsets.length - 1;
  if (count === 0) return [];
  const first = Math.max(0, rowAt(offsets, top) - BEYOND);
  const last = Math.min(count - 1, rowAt(offsets, top + height) + BEYOND);
  const indices = Array.from({ length: last - first + 1 }, (_, step) => first + step);
  if (kept !== null && kept >= 0 && kept < first) indices.unshift(kept);
  if (kept !== null && kept > last && kept < count) indices.push(kept);
  const drawn: Drawn[] = [];
  let end = 0;
  for (const index of indices) {
    const start = offsets[index] ?? 0;
    if (start > end) drawn.push({ kind: "gap", height: start - end });
    drawn.push({ kind: "row", index });
    end = offsets[index + 1] ?? start;
  }
  const total = offsets[count] ?? 0;
  if (total > end) drawn.push({ kind: "gap", height: total - end });
  return drawn;
}

/** Rows drawn beyond the edge, so that a flick of the wheel meets no blank. */
const BEYOND = 8;

/** How far to scroll so that a row is in sight below the table's head; the same when it is already. */
export function scrollTo(offsets: Float64Array, index: number, top: number, height: number): number {
  const start = offsets[index] ?? 0;
  const end = offsets[index + 1] ?? start;
  if (start < top) return start;
  return end > top + height ? end - height : top;
}
