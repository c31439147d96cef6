import type { Box } from "../document/box";
import type { Point } from "../document/formation";
import { clampCount, MOST_PLACES, type Spacing } from "./spacing";

const LATTICE = Math.sqrt(3) / 2;

/** Rows and columns that fill a box, the front row first; what is over of the count stands in the back row. */
export function placesInGrid(box: Box, spacing: Spacing): Point[] {
  const [width, depth] = sizeOf(box);
  if (spacing.by === "interval") {
    const columns = Math.min(MOST_PLACES, fitting(width, spacing.meters));
    const rows = Math.min(Math.floor(MOST_PLACES / columns), fitting(depth, spacing.meters));
    return lattice(columns * rows, columns, box.min, [spacing.meters, spacing.meters]);
  }
  const count = clampCount(spacing.count);
  const columns = columnsFor(count, width, depth);
  const rows = Math.ceil(count / columns);
  const step: Point = [columns > 1 ? width / (columns - 1) : 0, rows > 1 ? depth / (rows - 1) : 0];
  return lattice(count, columns, box.min, step);
}

/** Rows that fill a box, every other one set half a step aside. */
export function placesInBlock(box: Box, spacing: Spacing): Point[] {
  const [width, depth] = sizeOf(box);
  if (spacing.by === "interval") {
    const columns = Math.min(MOST_PLACES, fitting(width, spacing.meters));
    // A single column has nothing to stand beside: its rows keep the interval themselves.
    const dy = columns > 1 ? spacing.meters * LATTICE : spacing.meters;
    const counts = staggered(fitting(depth, dy), columns, MOST_PLACES);
    return rowsOf(counts, columns, box.min, [spacing.meters, dy]);
  }
  const count = clampCount(spacing.count);
  const columns = blockColumns(count, width, depth);
  const counts = staggered(count, columns, count);
  const step: Point = [columns > 1 ? width / (columns - 1) : 0, counts.length > 1 ? depth / (counts.length - 1) : 0];
  return rowsOf(counts, columns, box.min, step);
}

function lattice(count: number, columns: number, [left, front]: Point, [dx, dy]: Point): Point[] {
  return Array.from(
    { length: count },
    (_, i): Point => [left + (i % columns) * dx, front + Math.floor(i / columns) * dy],
  );
}

/** How many stand in each row: `columns` and one fewer by turns, up to `most` in all. */
function staggered(rows: number, columns: number, most: number): number[] {
  const counts: number[] = [];
  let left = most;
  while (counts.length < rows && left > 0) {
    const full = counts.length % 2 === 0 || columns === 1 ? columns : columns - 1;
    counts.push(Math.min(full, left));
    left -= full;
  }
  return counts;
}

/** Rows of one step; one fewer in a row sets it half a step aside. */
function rowsOf(counts: readonly number[], columns: number, [left, front]: Point, [dx, dy]: Point): Point[] {
  return counts.flatMap((count, row) => {
    const full = row % 2 === 0 || columns === 1 ? columns : columns - 1;
    const start = left + ((columns - full) * dx) / 2;
    return Array.from({ length: count }, (_, i): Point => [start + i * dx, front + row * dy]);
  });
}

/** Columns that make the cells most nearly square, preferring full rows where the cells stay within 5 : 4. */
function columnsFor(count: number, width: number, depth: number): number {
  const score = (columns: number): number => {
    const rows = Math.ceil(count / columns);
    const dx = columns > 1 ? width / (columns - 1) : width;
    const dy = rows > 1 ? depth / (rows - 1) : depth;
    const isFull = columns * rows === count;
    return Math.abs(Math.log(Math.max(dx, 1e-9) / Math.max(dy, 1e-9))) + (isFull ? 0 : Math.log(1.25));
  };
  return bestColumns(count, width, depth, score);
}

/** Columns that bring the rows nearest to a triangular lattice. */
function blockColumns(count: number, width: number, depth: number): number {
  const score = (columns: number): number => {
    const rows = staggered(count, columns, count).length;
    const dx = columns > 1 ? width / (columns - 1) : width;
    const dy = rows > 1 ? depth / (rows - 1) : depth;
    return Math.abs(Math.log(Math.max(dx * LATTICE, 1e-9) / Math.max(dy, 1e-9)));
  };
  return bestColumns(count, width, depth, score);
}

/** A box without width or depth is one row; else every number of columns is tried, the lower on a tie. */
function bestColumns(count: number, width: number, depth: number, score: (columns: number) => number): number {
  if (width <= 0) return 1;
  if (depth <= 0) return count;
  let best = 1;
  for (let columns = 2; columns <= count; columns += 1) if (score(columns) < score(best)) best = columns;
  return best;
}

function fitting(length: number, interval: number): number {
  return Math.max(1, Math.floor(length / interval + 1e-9) + 1);
}

function sizeOf({ min, max }: Box): Point {
  return [max[0] - min[0], max[1] - min[1]];
}
