import type { Units } from "../document/scene";
import { lengthWithUnit } from "../document/units";
import type { SegmentReport } from "../engine/api";

/** Meters, at most 0 within an obstacle; scene seconds. */
export interface Closest {
  readonly distance: number;
  readonly time: number;
  /** Who comes near an obstacle; absent of two agents. */
  readonly agent?: number;
}

/** What comes nearest in a transition: two agents, or one and an obstacle that it could not be led around. */
export function closestOf({ clearance, blocked = [] }: SegmentReport): Closest | null {
  const all: readonly Closest[] = clearance ? [clearance, ...blocked] : blocked;
  return all.reduce<Closest | null>((least, one) => (least && least.distance <= one.distance ? least : one), null);
}

/** How near that is: a distance, unless somebody goes through an obstacle. */
export function closestWords({ shutOff = [] }: SegmentReport, { distance, agent }: Closest, units: Units): string {
  if (agent === undefined || distance > 0) return lengthWithUnit(distance, units);
  return shutOff.some((shut) => shut.agent === agent) ? "shut off" : "inside";
}
