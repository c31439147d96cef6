import { expect, test } from "vitest";
import { countTicks, isWhole, secondTicks } from "./ruler";
import type { Scale } from "./scale";

const ZOOMS = [0.5, 3, 22, 71.6, 87, 400];

test.each(ZOOMS)("at %d pixels a second the labels never touch", (pixelsPerSecond) => {
  const labels = secondTicks({ origin: 62, pixelsPerSecond }, 0, 3000).filter((tick) => tick.label !== null);
  expect(labels.length).toBeGreaterThan(1);
  for (const [index, tick] of labels.slice(1).entries()) {
    expect(tick.x - (labels[index]?.x ?? 0)).toBeGreaterThanOrEqual(60);
  }
});

test.each(ZOOMS)("at %d pixels a second every label is the time where it stands, and no two are alike", (zoom) => {
  const scale: Scale = { origin: 62, pixelsPerSecond: zoom };
  const labels = secondTicks(scale, 0, 3000).flatMap((tick) => (tick.label === null ? [] : [tick]));
  expect(new Set(labels.map((tick) => tick.label)).size).toBe(labels.length);
  for (const { x, label } of labels) {
    const [minutes, seconds] = (label ?? "").split(":").map(Number);
    expect((minutes ?? 0) * 60 + (seconds ?? 0)).toBeCloseTo((x - 62) / zoom, 6);
  }
});

test("nothing is drawn before the show begins", () => {
  expect(secondTicks({ origin: 62, pixelsPerSecond: 20 }, -500, 61)).toEqual([]);
  expect(secondTicks({ origin: 62, pixelsPerSecond: 20 }, -500, 62)).toEqual([
    { x: 62, isStrong: false, label: "0:00" },
  ]);
});

const TEMPO = { beatsPerMinute: 120, beatsPerBar: 4, start: 0.25 };

test.each(ZOOMS)("at %d pixels a second numbers of bars and counts never touch", (pixelsPerSecond) => {
  const ticks = countTicks({ origin: 62, pixelsPerSecond }, TEMPO, 0, 3000);
  const labels = ticks.filter((tick) => tick.label !== null);
  expect(labels.length).toBeGreaterThan(1);
  for (const [index, tick] of labels.slice(1).entries()) {
    expect(tick.x - (labels[index]?.x ?? 0)).toBeGreaterThanOrEqual(60);
  }
  expect(new Set(labels.map((tick) => tick.label)).size).toBe(labels.length);
});

test.each(ZOOMS)("at %d pixels a second bar lines stand where bars begin, and stand out", (pixelsPerSecond) => {
  const ticks = countTicks({ origin: 62, pixelsPerSecond }, TEMPO, 0, 3000);
  const strong = ticks.filter((tick) => tick.isStrong);
  expect(strong.length).toBeGreaterThan(1);
  for (const { x } of strong) {
    const bars = ((x - 62) / pixelsPerSecond - TEMPO.start) / 2;
    expect(bars).toBeCloseTo(Math.round(bars), 6);
  }
});

test("counts lie between the bar lines where they are legible", () => {
  const ticks = countTicks({ origin: 0, pixelsPerSecond: 40 }, { ...TEMPO, start: 0 }, 0, 170);
  expect(ticks.map(({ x, isStrong, label }) => [x, isStrong, label])).toEqual([
    [0, true, "1"],
    [20, false, null],
    [40, false, null],
    [60, false, null],
    [80, true, "2"],
    [100, false, null],
    [120, false, null],
    [140, false, null],
    [160, true, "3"],
  ]);
});

test("no count is drawn before the show begins, and bars before the first count have numbers, too", () => {
  const ticks = countTicks({ origin: 0, pixelsPerSecond: 80 }, { ...TEMPO, start: 3 }, -400, 300);
  expect(ticks.every(({ x }) => x >= 0)).toBe(true);
  expect(ticks.flatMap(({ label }) => label ?? [])).toEqual(["0", "1"]);
});

test("a label that the window would cut is none", () => {
  const seconds = (x: number) => isWhole(x, false, 100, 900);
  expect([100, 110, 120, 880, 890, 900].map(seconds)).toEqual([false, false, true, true, false, false]);
  // The number of a bar stands to the right of its line.
  const bars = (x: number) => isWhole(x, true, 100, 900);
  expect([99, 100, 870, 890].map(bars)).toEqual([false, true, true, false]);
});
