import { expect, test } from "vitest";
import { momentX, ribbonPath, ribbonStart } from "./ribbon";

const HEIGHT = 54;

/** Every coordinate of a path, by command letters M, L, C and V. */
function places(path: string): { xs: number[]; ys: number[] } {
  const xs: number[] = [];
  const ys: number[] = [];
  for (const [, letter, body] of path.matchAll(/([MLCVZ])([^MLCVZ]*)/g)) {
    const numbers = (body ?? "")
      .trim()
      .split(/[\s,]+/)
      .filter(Boolean)
      .map(Number);
    if (letter === "V") ys.push(...numbers);
    else for (const [index, value] of numbers.entries()) (index % 2 === 0 ? xs : ys).push(value);
  }
  return { xs, ys };
}

function cases(): [status: "holds" | "tight" | "clash" | "none", width: number, moment: number][] {
  const all: [status: "holds" | "tight" | "clash" | "none", width: number, moment: number][] = [];
  for (const status of ["holds", "tight", "clash", "none"] as const) {
    for (const width of [3, 12, 80, 400]) for (const moment of [-1, 0, 0.3, 1, 2]) all.push([status, width, moment]);
  }
  return all;
}

test.each(cases())("a %s ribbon %d wide with its moment at %d stays in its box", (status, width, moment) => {
  const { xs, ys } = places(ribbonPath(status, width, HEIGHT, moment));
  for (const x of xs) {
    expect(x).toBeGreaterThanOrEqual(0);
    expect(x).toBeLessThanOrEqual(width);
  }
  for (const y of ys) {
    expect(y).toBeGreaterThanOrEqual(HEIGHT / 2 - 10);
    expect(y).toBeLessThanOrEqual(HEIGHT / 2 + 10);
  }
});

test("a clash is in two pieces, a tight one in one", () => {
  expect(ribbonPath("clash", 200, HEIGHT, 0.5).match(/M/g)).toHaveLength(2);
  expect(ribbonPath("tight", 200, HEIGHT, 0.5).match(/M/g)).toHaveLength(1);
});

test("a tight ribbon is thinnest at its moment", () => {
  const { xs, ys } = places(ribbonPath("tight", 200, HEIGHT, 0.6));
  const thinnest = ys.reduce(
    (best, y, index) => {
      const isInside = (xs[index] ?? 0) > 0;
      return isInside && Math.abs(y - HEIGHT / 2) < Math.abs((ys[best] ?? 0) - HEIGHT / 2) ? index : best;
    },
    xs.findIndex((x) => x > 0),
  );
  expect(Math.abs((xs[thinnest] ?? 0) - 120)).toBeLessThanOrEqual(10);
});

test("what has been planned grows along the wedge and ends as the whole of it", () => {
  const reach = (share: number) => Math.max(...places(ribbonStart(share, 200, HEIGHT)).xs);
  expect([0.25, 0.5, 1].map(reach)).toEqual([50, 100, 200]);
  expect(ribbonStart(0, 200, HEIGHT)).toBe("");
  expect(ribbonStart(1, 200, HEIGHT)).toBe(ribbonPath("holds", 200, HEIGHT, 0));
});

test("where there is no room there is no ribbon", () => {
  expect(ribbonPath("holds", 1, HEIGHT, 0.5)).toBe("");
});

test("a mark at the very start or end is drawn whole", () => {
  expect(momentX(-0.2, 100, 20)).toBe(20);
  expect(momentX(1.4, 100, 20)).toBe(80);
  expect(momentX(0.5, 100, 20)).toBe(50);
});
