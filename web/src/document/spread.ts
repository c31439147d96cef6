/** How many places of a rectangle, meters, can be `distance` apart at most (Oler's bound, as `eigenform check` counts). */
export function mostApart(width: number, depth: number, distance: number): number {
  if (distance <= 0) return Number.POSITIVE_INFINITY;
  const [w, d] = [width / distance, depth / distance];
  return Math.floor((2 / Math.sqrt(3)) * w * d + w + d + 1 + 1e-9);
}

/** A distance at which so many surely fit: the widest of square grids, in whole centimeters. */
export function widestApart(width: number, depth: number, count: number): number {
  const along = (length: number, places: number) => (places > 1 ? length / (places - 1) : Number.POSITIVE_INFINITY);
  let widest = 0;
  for (let rows = 1; rows <= count; rows += 1) {
    widest = Math.max(widest, Math.min(along(width, Math.ceil(count / rows)), along(depth, rows)));
  }
  return Math.floor(100 * widest + 1e-9) / 100;
}
