import type { Units } from "../../document/scene";
import { formatAngle, formatCount, formatLength, formatNumber } from "../../document/units";
import type { SegmentReport } from "../../engine/api";

/** A measure of every way, as it is read. */
export interface MeasureRow {
  readonly label: string;
  /** By way; null while it is not known, or where there is none. */
  readonly values: readonly (string | null)[];
  /** The way that reads better than all others; null where none does or not all are known. */
  readonly best: number | null;
}

interface Measure {
  readonly label: string;
  readonly isMoreBetter?: boolean;
  /** Left out where no way has it. */
  readonly isOptional?: boolean;
  value(report: SegmentReport): number | null;
  format(value: number): string;
}

function measures(units: Units): readonly Measure[] {
  const meters = (value: number) => `${formatLength(value, units)} ${units}`;
  return [
    { label: "Clearance", isMoreBetter: true, value: (report) => report.clearance?.distance ?? null, format: meters },
    {
      label: "before avoiding",
      isMoreBetter: true,
      isOptional: true,
      value: (report) => report.guideClearance?.distance ?? null,
      format: meters,
    },
    { label: "Near collisions", value: (report) => report.nearCollisions, format: formatCount },
    { label: "Distortion", value: (report) => report.distortion.mean, format: formatNumber },
    { label: "at most", value: (report) => report.distortion.max, format: formatNumber },
    { label: "Turning", value: (report) => report.turning.mean, format: formatAngle },
    { label: "at most", value: (report) => report.turning.max, format: formatAngle },
    { label: "Path length", value: (report) => report.pathLength.mean, format: meters },
    { label: "Top speed", value: (report) => report.topSpeed.speed, format: (value) => `${meters(value)}/s` },
    { label: "Moved to avoid", value: (report) => report.deviation?.max ?? null, format: meters, isOptional: true },
    { label: "Missed by", value: (report) => report.arrivalError?.max ?? null, format: meters, isOptional: true },
    { label: "Unsolved", value: (report) => report.unsolved?.length ?? null, format: formatCount, isOptional: true },
  ];
}

/** The measures of all ways. */
export function measureRows(reports: readonly (SegmentReport | null)[], units: Units): MeasureRow[] {
  const told = measures(units).filter(
    ({ isOptional, value }) => !isOptional || reports.some((report) => report && value(report) !== null),
  );
  return told.map(({ label, isMoreBetter = false, value, format }) => {
    const numbers = reports.map((report) => report && value(report));
    const values = numbers.map((number) => (number === null ? null : format(number)));
    return { label, values, best: bestOf(numbers, values, isMoreBetter) };
  });
}

/** Numbers that read the same are equally good. */
function bestOf(
  numbers: readonly (number | null)[],
  values: readonly (string | null)[],
  isMoreBetter: boolean,
): number | null {
  const known = numbers.filter((number) => number !== null);
  if (known.length < numbers.length) return null;
  const best = known.indexOf(isMoreBetter ? Math.max(...known) : Math.min(...known));
  return values.filter((value) => value === values[best]).length === 1 ? best : null;
}
