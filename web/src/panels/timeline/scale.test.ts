import fc from "fast-check";
import { expect, test } from "vitest";
import {
  fittedZoom,
  type Scale,
  scrollAfterZoom,
  scrollToReveal,
  THUMBNAIL_WIDTH,
  timeAt,
  trackWidth,
  xOf,
} from "./scale";

const MARGINS = { lead: 62, tail: 150 };
const scales = fc.record({
  origin: fc.double({ min: 0, max: 100, noNaN: true }),
  pixelsPerSecond: fc.double({ min: 0.5, max: 400, noNaN: true }),
});

test("a time stands at one place, and the place gives the time back", () => {
  fc.assert(
    fc.property(scales, fc.double({ min: 0, max: 3600, noNaN: true }), (scale, time) => {
      // Two roundings of numbers up to 3600 · 400 pixels, divided by at least half a pixel a second.
      expect(Math.abs(timeAt(scale, xOf(scale, time)) - time)).toBeLessThan(1e-8);
    }),
  );
});

test("zooming keeps what is under the pointer under the pointer", () => {
  fc.assert(
    fc.property(scales, scales, fc.nat(2000), fc.nat(1440), (one, other, scroll, pointer) => {
      const before: Scale = one;
      const after: Scale = { ...other, origin: one.origin };
      const scrolled = scrollAfterZoom(before, after, scroll, pointer);
      // The zoom may grow 800 times, and with it the rounding of the time under the pointer.
      expect(Math.abs(timeAt(after, scrolled + pointer) - timeAt(before, scroll + pointer))).toBeLessThan(1e-6);
    }),
  );
});

test("a short show is seen whole at first", () => {
  const pixelsPerSecond = fittedZoom([5, 4, 5], 14, 1440, MARGINS);
  expect(trackWidth({ origin: 62, pixelsPerSecond }, 14, 1440, MARGINS)).toBeLessThanOrEqual(1440);
});

test("in a long show the typical ribbon has room for its label at first", () => {
  const intervals = new Array<number>(22).fill(15);
  const pixelsPerSecond = fittedZoom(intervals, 330, 1440, MARGINS);
  expect(15 * pixelsPerSecond - THUMBNAIL_WIDTH).toBeGreaterThan(60);
});

test("what is seen already is not scrolled to", () => {
  expect(scrollToReveal(500, 200, 1440)).toBe(200);
});

test.each([0, 150, 1700, 9000])("what is at %d is in the window after it was scrolled to", (x) => {
  const scroll = scrollToReveal(x, 200, 1440);
  expect(x).toBeGreaterThanOrEqual(scroll);
  expect(x).toBeLessThanOrEqual(scroll + 1440);
});
