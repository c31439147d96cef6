import type { Units } from "../../../document/scene";
import { metersPer } from "../../../document/units";
import type { Compared } from "../../../engine/comparison";

/** A number of every way. */
export interface Column {
  readonly label: string;
  /** Empty for none. */
  readonly unit: string;
  /** What the label means. */
  readonly meaning: string;
  readonly decimals: number;
  readonly isMoreBetter?: boolean;
  /** Null where there is none. */
  value(compared: Compared): number | null;
}

/** Averages over time, as in the papers; lengths in the scene's units. */
export function columnsFor(units: Units): readonly Column[] {
  const per = metersPer(units);
  const length = (value: number | null | undefined) => (value === null || value === undefined ? null : value / per);
  const degrees = (radians: number) => (radians * 180) / Math.PI;
  return [
    { label: "Time", unit: "s", meaning: "until everybody is there", decimals: 2, value: ({ time }) => time },
    {
      label: "Direction told",
      unit: "bits",
      meaning: "I_d, how much place tells of direction",
      decimals: 3,
      value: (way) => way.mutualInformation.mean,
    },
    {
      label: "Speed told",
      unit: "bits",
      meaning: "I_v, how much place tells of speed",
      decimals: 3,
      value: (way) => way.speedInformation.mean,
    },
    {
      label: "Structure σ",
      unit: units,
      meaning: "deviation of the distances to the nearest",
      decimals: 3,
      value: (way) => length(way.structureDeviation.mean),
    },
    {
      label: "Effort σ",
      unit: units,
      meaning: "deviation of the distances from the start",
      decimals: 3,
      value: (way) => length(way.effortDeviation.mean),
    },
    {
      label: "To the target",
      unit: units,
      meaning: "mean distance to the target's places",
      decimals: 2,
      value: (way) => length(way.targetDeviation.mean),
    },
    {
      label: "Clearance",
      unit: units,
      meaning: "the nearest that any two come",
      decimals: 2,
      isMoreBetter: true,
      value: (way) => length(way.clearance?.distance),
    },
    {
      label: "Turning",
      unit: "°",
      meaning: "of everybody on average",
      decimals: 0,
      value: (way) => degrees(way.turning.mean),
    },
    {
      label: "Path",
      unit: units,
      meaning: "walked on average",
      decimals: 2,
      value: (way) => length(way.pathLength.mean),
    },
    {
      label: "Jerk",
      unit: "m/s³",
      meaning: "the median, how roughly it runs",
      decimals: 2,
      value: (way) => way.roughness,
    },
    {
      label: "Missed by",
      unit: units,
      meaning: "how far forces alone leave somebody from the target",
      decimals: 2,
      value: (way) => length(way.arrivalError?.max),
    },
  ];
}

/** What a cell reads; a dash where there is no number. */
export function cellText({ decimals, value }: Column, compared: Compared): string {
  const number = value(compared);
  return number === null ? "–" : number.toFixed(decimals);
}

/** The rows that read better than all others of a column; none where all read the same. */
export function bestRows(column: Column, all: readonly (Compared | null)[]): ReadonlySet<number> {
  const numbers = all.map((compared) => {
    const number = compared && column.value(compared);
    return number === null ? null : Number(number.toFixed(column.decimals));
  });
  const known = numbers.filter((number) => number !== null);
  const best = column.isMoreBetter ? Math.max(...known) : Math.min(...known);
  if (known.length < 2 || known.every((number) => number === best)) return new Set();
  return new Set(numbers.flatMap((number, row) => (number === best ? [row] : [])));
}

/** A row of the table: who, and the numbers once they are there. */
export interface NamedRow {
  readonly cost: string;
  readonly way: string;
  readonly compared: Compared | null;
}

/** The table as it is pasted into others: tab separated, a head with units, a point before the decimals. */
export function tabSeparated(rows: readonly NamedRow[], columns: readonly Column[]): string {
  const head = ["Who goes where", "Method", ...columns.map(({ label, unit }) => `${label} (${unit})`)];
  const lines = rows.map(({ cost, way, compared }) => [
    cost,
    way,
    ...columns.map((column) => (compared && column.value(compared) !== null ? cellText(column, compared) : "")),
  ]);
  return [head, ...lines].map((cells) => `${cells.join("\t")}\n`).join("");
}
