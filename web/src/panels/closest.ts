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

/** Whether a distance says how near that is: not where somebody goes through an obstacle. */
export function isDistance({ distance, agent }: Closest): boolean {
  return agent === undefined || distance > 0;
}

/** How near that is: a distance, unless somebody goes through an obstacle. */
export function closestWords({ shutOff = [] }: SegmentReport, closest: Closest, units: Units): string {
  if (isDistance(closest)) return lengthWithUnit(closest.distance, units);
  return shutOff.some(({ agent }) => agent === closest.agent) ? "shut off" : "inside";
}
