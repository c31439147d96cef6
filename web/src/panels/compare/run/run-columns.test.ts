import { expect, test } from "vitest";
import type { Compared } from "../../../engine/comparison";
import { bestRows, cellText, columnsFor, tabSeparated } from "./run-columns";

const extreme = (mean: number) => ({ mean, max: 2 * mean });

function compared(change: Partial<Compared> = {}): Compared {
  return {
    time: 6,
    mutualInformation: extreme(0.5),
    speedInformation: extreme(0.25),
    structureDeviation: extreme(0.3048),
    effortDeviation: extreme(1),
    targetDeviation: extreme(2),
    roughness: 0.1,
    clearance: { distance: 0.5, time: 1, agents: [0, 1] },
    distortion: extreme(0.1),
    turning: extreme(Math.PI / 2),
    pathLength: extreme(4),
    topSpeed: { speed: 2, time: 1, agent: 0 },
    curves: {
      times: [],
      mutualInformation: [],
      speedInformation: [],
      structureDeviation: [],
      effortDeviation: [],
      targetDeviation: [],
    },
    ...change,
  };
}

const column = (label: string, units: "m" | "ft" = "m") => {
  const found = columnsFor(units).find((one) => one.label === label);
  if (!found) throw new Error(`${label} is a column`);
  return found;
};

test("lengths are in the scene's units, and what never happens is a dash", () => {
  expect(cellText(column("Structure σ", "ft"), compared())).toBe("1.000");
  expect(cellText(column("Turning"), compared())).toBe("90");
  expect(cellText(column("Time"), compared({ time: null }))).toBe("–");
  expect(cellText(column("Missed by"), compared())).toBe("–");
});

test("the better read stands out, all that read alike, and nothing where all do", () => {
  const near = compared({ clearance: { distance: 0.1, time: 1, agents: [0, 1] } });
  expect([...bestRows(column("Clearance"), [compared(), near, compared(), null])]).toEqual([0, 2]);
  expect([...bestRows(column("Time"), [compared({ time: null }), compared(), compared({ time: 5 })])]).toEqual([2]);
  expect(bestRows(column("Path"), [compared(), near]).size).toBe(0);
  expect(bestRows(column("Path"), [compared(), null]).size).toBe(0);
});

test("the table is pasted as cells: as many in every line, and a number is one for every spreadsheet", () => {
  const text = tabSeparated(
    [
      { cost: "Least effort", way: "Crowd", compared: compared({ time: null }) },
      { cost: "Least effort", way: "ORCA alone", compared: null },
    ],
    columnsFor("m"),
  );
  const lines = text
    .replace(/\n$/, "")
    .split("\n")
    .map((line) => line.split("\t"));
  expect(new Set(lines.map((cells) => cells.length))).toEqual(new Set([2 + columnsFor("m").length]));
  expect(lines[0]?.slice(0, 3)).toEqual(["Who goes where", "Method", "Time (s)"]);
  expect(lines[1]?.slice(0, 4)).toEqual(["Least effort", "Crowd", "", "0.500"]);
  expect(lines[2]?.slice(2).every((cell) => cell === "")).toBe(true);
});
