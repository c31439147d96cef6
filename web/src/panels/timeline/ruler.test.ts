import { expect, test } from "vitest";
import { rulerTicks } from "./ruler";
import type { Scale } from "./scale";

const ZOOMS = [0.5, 3, 22, 71.6, 87, 400];

test.each(ZOOMS)("at %d pixels a second the labels never touch", (pixelsPerSecond) => {
  const labels = rulerTicks({ origin: 62, pixelsPerSecond }, 0, 3000).filter((tick) => tick.label !== null);
  expect(labels.length).toBeGreaterThan(1);
  for (const [index, tick] of labels.slice(1).entries()) {
    expect(tick.x - (labels[index]?.x ?? 0)).toBeGreaterThanOrEqual(60);
  }
});

test.each(ZOOMS)("at %d pixels a second every label is the time where it stands, and no two are alike", (zoom) => {
  const scale: Scale = { origin: 62, pixelsPerSecond: zoom };
  const labels = rulerTicks(scale, 0, 3000).flatMap((tick) => (tick.label === null ? [] : [tick]));
  expect(new Set(labels.map((tick) => tick.label)).size).toBe(labels.length);
  for (const { x, label } of labels) {
    const [minutes, seconds] = (label ?? "").split(":").map(Number);
    expect((minutes ?? 0) * 60 + (seconds ?? 0)).toBeCloseTo((x - 62) / zoom, 6);
  }
});

test("nothing is drawn before the show begins", () => {
  expect(rulerTicks({ origin: 62, pixelsPerSecond: 20 }, -500, 61)).toEqual([]);
  expect(rulerTicks({ origin: 62, pixelsPerSecond: 20 }, -500, 62)).toEqual([{ x: 62, label: "0:00" }]);
});
