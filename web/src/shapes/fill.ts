import type { Point } from "../document/formation";
import { Buckets } from "./buckets";
import { placesAround } from "./path";
import { type Raster, rasterOf } from "./polygon";
import { countWithin, type Spacing } from "./spacing";

/** Squares of the raster for each place: enough that a cell's middle is known to a tenth of the spacing. */
const SQUARES_A_PLACE = 24;
/** Rounds times places: unevenness falls fastest in the first rounds, and in a crowd the eye sees less of it. */
const ROUNDS_A_PLACE = 8000;

/** How much work a fill may be: while the pointer still moves, a crowd is shown roughly where it will stand. */
export type Effort = "preview" | "full";

/** Bounds on squares and rounds; 5,000 places still have five squares each in the end. */
const MOST: Readonly<Record<Effort, { readonly squares: number; readonly rounds: number }>> = {
  preview: { squares: 7000, rounds: 6 },
  full: { squares: 24_000, rounds: 16 },
};

/**
 * Places evenly spread over the inside of a closed path, exactly as many as asked; the same for the same path.
 *
 * The region is cut into equal parts in rows, a place in each; every place then moves to the middle of what is nearest
 * to it, again and again (Lloyd's relaxation). A path without an inside is lined instead.
 */
export function placesInside(polygon: readonly Point[], spacing: Spacing, effort: Effort = "full"): Point[] {
  const coarse = rasterOf(polygon, 2000);
  if (!coarse) return placesAround(polygon, spacing);
  const count = countWithin(coarse.middles.length * coarse.side ** 2, spacing);
  const { squares, rounds: most } = MOST[effort];
  const raster = rasterOf(polygon, Math.max(400, Math.min(squares, count * SQUARES_A_PLACE))) ?? coarse;
  if (raster.middles.length < count) return placesAround(polygon, { by: "count", count });
  const places = seeds(raster, count);
  const rounds = Math.max(4, Math.min(most, Math.round(ROUNDS_A_PLACE / count)));
  for (let round = 0; round < rounds; round += 1) moveToMiddles(raster, places);
  return ontoRegion(raster, places);
}

/** Distinct squares, one in the middle of each of `count` equal parts of the area; the parts lie in rows. x, y a place. */
function seeds({ middles, side }: Raster, count: number): Float64Array {
  // The distance between the rows of a triangular lattice of as many places.
  const across = side * Math.sqrt((Math.sqrt(3) / 2) * (middles.length / count));
  const order = middles
    .map((middle, index) => {
      const row = Math.floor(middle[1] / across);
      // Rows run to and fro, so that equal parts of the order are compact parts of the region.
      const x = row % 2 === 0 ? middle[0] : -middle[0];
      return { index, row, x };
    })
    .sort((a, b) => a.row - b.row || a.x - b.x || a.index - b.index);
  const xy = new Float64Array(2 * count);
  for (let i = 0; i < count; i += 1) {
    const pick = order[Math.floor(((i + 0.5) * order.length) / count)];
    const [x, y] = middles[pick?.index ?? 0] ?? [0, 0];
    xy[2 * i] = x;
    xy[2 * i + 1] = y;
  }
  return xy;
}

/** One round: every place goes to the mean of the squares nearest to it. */
function moveToMiddles(raster: Raster, xy: Float64Array): void {
  const count = xy.length / 2;
  const sums = new Float64Array(2 * count);
  const masses = new Uint32Array(count);
  const buckets = bucketsFor(raster, xy);
  for (const [x, y] of raster.middles) {
    const place = buckets.nearest(x, y);
    sums[2 * place] = (sums[2 * place] ?? 0) + x;
    sums[2 * place + 1] = (sums[2 * place + 1] ?? 0) + y;
    masses[place] = (masses[place] ?? 0) + 1;
  }
  for (let place = 0; place < count; place += 1) {
    const mass = masses[place] ?? 0;
    if (mass === 0) continue;
    xy[2 * place] = (sums[2 * place] ?? 0) / mass;
    xy[2 * place + 1] = (sums[2 * place + 1] ?? 0) / mass;
  }
}

/** The middle of a bent cell can lie outside the region: it gives way to the nearest square of its own. */
function ontoRegion(raster: Raster, xy: Float64Array): Point[] {
  const { middles, side } = raster;
  const buckets = bucketsFor(raster, xy);
  const best = Array.from({ length: xy.length / 2 }, () => ({ square: -1, distance: Number.POSITIVE_INFINITY }));
  for (const [square, [x, y]] of middles.entries()) {
    const place = buckets.nearest(x, y);
    const mine = best[place];
    const distance = Math.hypot((xy[2 * place] ?? 0) - x, (xy[2 * place + 1] ?? 0) - y);
    if (mine && distance < mine.distance) best[place] = { square, distance };
  }
  return best.map(({ square, distance }, place): Point => {
    const own = middles[square];
    const isOnSquare = distance <= side / Math.SQRT2;
    return own && !isOnSquare ? own : [xy[2 * place] ?? 0, xy[2 * place + 1] ?? 0];
  });
}

function bucketsFor({ middles, side }: Raster, xy: Float64Array): Buckets {
  return new Buckets(xy, side * Math.sqrt(middles.length / (xy.length / 2)));
}
