import type { Units } from "../../document/scene";
import { formatAngle, formatCount, formatLength, formatNumber } from "../../document/units";
import type { SegmentReport } from "../../engine/api";

/** Which side a measure speaks for. */
export type Better = "left" | "right" | "neither";

/** A measure of both sides, as it is read. */
export interface MeasureRow {
  readonly label: string;
  /** Null while it is not known, or where there is none. */
  readonly left: string | null;
  readonly right: string | null;
  readonly better: Better;
}

interface Measure {
  readonly label: string;
  readonly isMoreBetter?: boolean;
  /** Left out where neither side has it. */
  readonly isOptional?: boolean;
  value(report: SegmentReport): number | null;
  format(value: number): string;
}

function measures(units: Units): readonly Measure[] {
  const meters = (value: number) => `${formatLength(value, units)} ${units}`;
  return [
    { label: "Clearance", isMoreBetter: true, value: (report) => report.clearance?.distance ?? null, format: meters },
    { label: "Near collisions", value: (report) => report.nearCollisions, format: formatCount },
    { label: "Distortion", value: (report) => report.distortion.mean, format: formatNumber },
    { label: "at most", value: (report) => report.distortion.max, format: formatNumber },
    { label: "Turning", value: (report) => report.turning.mean, format: formatAngle },
    { label: "at most", value: (report) => report.turning.max, format: formatAngle },
    { label: "Path length", value: (report) => report.pathLength.mean, format: meters },
    { label: "Top speed", value: (report) => report.topSpeed.speed, format: (value) => `${meters(value)}/s` },
    { label: "Moved to avoid", value: (report) => report.deviation?.max ?? null, format: meters, isOptional: true },
    { label: "Unsolved", value: (report) => report.unsolved?.length ?? null, format: formatCount, isOptional: true },
  ];
}

/** Both columns of measures; of two values that read differently the better one is marked. */
export function measureRows(left: SegmentReport | null, right: SegmentReport | null, units: Units): MeasureRow[] {
  const told = measures(units).filter(
    ({ isOptional, value }) => !isOptional || [left, right].some((report) => report && value(report) !== null),
  );
  return told.map(({ label, isMoreBetter = false, value, format }) => {
    const [a, b] = [left && value(left), right && value(right)];
    const [read, other] = [a === null ? null : format(a), b === null ? null : format(b)];
    return { label, left: read, right: other, better: betterOf(a, b, read === other, isMoreBetter) };
  });
}

function betterOf(a: number | null, b: number | null, isSame: boolean, isMoreBetter: boolean): Better {
  if (a === null || b === null || isSame) return "neither";
  return a > b === isMoreBetter ? "left" : "right";
}
