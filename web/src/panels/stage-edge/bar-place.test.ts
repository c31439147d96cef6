import fc from "fast-check";
import { expect, test } from "vitest";
import { placeBar } from "./bar-place";

const stage = { width: 1000, height: 700 };
const bar = { width: 200, height: 34 };

test("the bar stands centered below the selection", () => {
  expect(placeBar({ left: 400, top: 200, right: 600, bottom: 300 }, bar, stage)).toEqual({ left: 400, top: 314 });
});

test("above, clear of the rotate handle, when there is no room below", () => {
  const box = { left: 400, top: 400, right: 600, bottom: 680 };
  expect(placeBar(box, bar, stage).top + bar.height).toBeLessThanOrEqual(box.top - 22);
});

test("above a sheet that lies over the lower part of the stage", () => {
  const at = placeBar({ left: 400, top: 300, right: 600, bottom: 500 }, bar, stage, 400);
  expect(at.top).toBeGreaterThanOrEqual(0);
  expect(at.top + bar.height).toBeLessThanOrEqual(300);
});

test("wherever the selection is, even out of sight, the bar can be reached", () => {
  const place = fc.integer({ min: -3000, max: 3000 });
  const extent = fc.integer({ min: 0, max: 3000 });
  fc.assert(
    fc.property(place, place, extent, extent, (left, top, width, height) => {
      const at = placeBar({ left, top, right: left + width, bottom: top + height }, bar, stage);
      expect(at.left).toBeGreaterThanOrEqual(0);
      expect(at.top).toBeGreaterThanOrEqual(0);
      expect(at.left + bar.width).toBeLessThanOrEqual(stage.width);
      expect(at.top + bar.height).toBeLessThanOrEqual(stage.height);
    }),
  );
});
