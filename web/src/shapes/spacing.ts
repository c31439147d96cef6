/** How many places a stroke or shape makes: so many, or one every so many meters. */
export type Spacing =
  | { readonly by: "count"; readonly count: number }
  | { readonly by: "interval"; readonly meters: number };

/** No shape makes more places than a scene has agents. */
export const MOST_PLACES = 5000;

/** Places along a path with two ends, both occupied: by interval as many as fit. */
export function countAlong(length: number, spacing: Spacing): number {
  if (spacing.by === "count") return clampCount(spacing.count);
  return clampCount(Math.floor(length / spacing.meters + 1e-9) + 1);
}

/** Places around a closed path: by interval as near to it as whole places allow. */
export function countAround(length: number, spacing: Spacing): number {
  if (spacing.by === "count") return clampCount(spacing.count);
  return clampCount(Math.round(length / spacing.meters));
}

/** Places in a region whose interval is that of a triangular lattice: each takes √3/2 · interval² of the area. */
export function countWithin(area: number, spacing: Spacing): number {
  if (spacing.by === "count") return clampCount(spacing.count);
  return clampCount(Math.round(area / ((Math.sqrt(3) / 2) * spacing.meters ** 2)));
}

export function clampCount(count: number): number {
  return Number.isNaN(count) ? 1 : Math.max(1, Math.min(MOST_PLACES, Math.round(count)));
}
