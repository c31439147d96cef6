import fc from "fast-check";
import { expect, test } from "vitest";
import { placeFor, type Side } from "./place-beside";

const window = { width: 400, height: 300 };

test("a menu opens below its button, above when there is no room below", () => {
  const panel = { width: 100, height: 120 };
  expect(placeFor({ left: 20, top: 10, right: 60, bottom: 40 }, panel, window, "below").top).toBeGreaterThan(40);
  expect(placeFor({ left: 20, top: 250, right: 60, bottom: 280 }, panel, window, "below").top).toBeLessThan(130);
});

test("what is said of a field stands beside its row, over no field, where there is room", () => {
  const panel = { width: 100, height: 20 };
  const aside = (left: number, right: number) =>
    placeFor({ left, top: 50, right, bottom: 80 }, panel, window, "outside");
  expect(aside(200, 390)).toEqual({ left: 94, top: 55 });
  expect(aside(20, 200)).toEqual({ left: 206, top: 55 });
  expect(aside(20, 390).top).toBeGreaterThan(80);
});

test("a panel that fits the window stays in it wherever its button is", () => {
  const anchors = fc.record({ left: fc.integer({ min: -50, max: 450 }), top: fc.integer({ min: -50, max: 350 }) });
  const panels = fc.record({ width: fc.integer({ min: 1, max: 380 }), height: fc.integer({ min: 1, max: 280 }) });
  const sides = fc.constantFrom<Side>("below", "below-end", "above", "right", "outside");
  fc.assert(
    fc.property(anchors, panels, sides, ({ left, top }, panel, side) => {
      const place = placeFor({ left, top, right: left + 30, bottom: top + 30 }, panel, window, side);
      expect(place.left).toBeGreaterThanOrEqual(0);
      expect(place.top).toBeGreaterThanOrEqual(0);
      expect(place.left + panel.width).toBeLessThanOrEqual(window.width);
      expect(place.top + panel.height).toBeLessThanOrEqual(window.height);
    }),
  );
});
