import type { SegmentReport } from "../engine/api";

/** Meters, at most 0 within an obstacle; scene seconds. */
export interface Closest {
  readonly distance: number;
  readonly time: number;
}

/** What comes nearest in a transition: two agents, or one and an obstacle that it could not be led around. */
export function closestOf({ clearance, blocked = [] }: SegmentReport): Closest | null {
  const all: readonly Closest[] = clearance ? [clearance, ...blocked] : blocked;
  return all.reduce<Closest | null>((least, one) => (least && least.distance <= one.distance ? least : one), null);
}
