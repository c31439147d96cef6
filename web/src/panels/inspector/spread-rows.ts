import type { Units } from "../../document/scene";
import { formatNumber, lengthWithUnit } from "../../document/units";
import type { SegmentReport } from "../../engine/api";
import type { SalvageReport } from "../../engine/salvage";

/** One number of both motions, in words. */
export interface SpreadRow {
  readonly label: string;
  readonly was: string;
  readonly now: string;
}

/** How near they come, how far they go aside and how fast, before and after they spread out. */
export function spreadRows(before: SegmentReport | null, after: SalvageReport, units: Units): SpreadRow[] {
  const length = (meters: number | undefined) => (meters === undefined ? "–" : lengthWithUnit(meters, units));
  const speed = (value: number | undefined) => {
    if (value === undefined) return "–";
    return after.guideTopSpeed > 0 ? `× ${formatNumber(value / after.guideTopSpeed)}` : "× 1.00";
  };
  return [
    { label: "Nearest", was: length(before?.clearance?.distance), now: length(after.clearance?.distance) },
    { label: "Farthest aside", was: length(before?.deviation?.max), now: length(after.deviation.max) },
    { label: "Top speed", was: speed(before?.topSpeed.speed), now: speed(after.topSpeed) },
  ];
}
