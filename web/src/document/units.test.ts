import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { parseLength, parseNumber, parseTime } from "./parse";
import { formatAngle, formatDuration, formatLength, formatNumber, formatTime, lengthWithUnit } from "./units";

const UNITS = ["m", "ft", "yd", "steps"] as const;

describe("lengths", () => {
  test("a length reads in the scene's units", () => {
    expect(formatLength(0.9144, "yd")).toBe("1.00");
    expect(formatLength(4.572, "steps")).toBe("8.00");
    expect(lengthWithUnit(0.3048, "ft")).toBe("1.00 ft");
  });

  test("a negative length has a true minus, and zero has none", () => {
    expect(formatNumber(-0.47)).toBe("−0.47");
    expect(formatNumber(-0.001)).toBe("0.00");
  });

  test("what is shown can be typed back, to half of the last digit shown", () => {
    fc.assert(
      fc.property(fc.double({ min: -1e4, max: 1e4, noNaN: true }), fc.constantFrom(...UNITS), (meters, units) => {
        const typed = parseLength(lengthWithUnit(meters, units), units);
        // 0.005 of a unit by rounding, at most 0.0046 m in yards, and round-off of the quotient.
        expect(Math.abs((typed ?? Number.NaN) - meters)).toBeLessThanOrEqual(0.005 + 1e-9);
      }),
    );
  });

  test("a unit that is typed wins over the scene's", () => {
    expect(parseLength("10 yd", "m")).toBeCloseTo(9.144, 12);
    expect(parseLength("-2'", "m")).toBeCloseTo(-0.6096, 12);
    expect(parseLength("8 steps", "m")).toBeCloseTo(4.572, 12);
  });

  test("a comma before the decimals is a point", () => {
    expect(parseNumber("1,5")).toBe(1.5);
    expect(parseNumber("−1,5")).toBe(-1.5);
  });

  test.each(["", "m", "abc", "1 parsec", "1.2.3", "--1", "1e999", "."])("%o is no length", (text) => {
    expect(parseLength(text, "m")).toBeNull();
  });
});

describe("times", () => {
  test("a time reads in minutes, seconds and tenths", () => {
    expect(formatTime(5.3)).toBe("0:05.3");
    expect(formatTime(205.8)).toBe("3:25.8");
  });

  test("a clock never shows sixty seconds nor runs ahead", () => {
    expect(formatTime(59.99)).toBe("0:59.9");
    expect(formatTime(60)).toBe("1:00.0");
  });

  test("every tenth that is shown can be typed back", () => {
    fc.assert(
      fc.property(fc.integer({ min: 0, max: 36_000 }), (tenths) => {
        expect(parseTime(formatTime(tenths / 10))).toBeCloseTo(tenths / 10, 9);
      }),
    );
  });

  test.each(["", "1:75", "1:2:3:4", "-1", "a"])("%o is no time", (text) => {
    expect(parseTime(text)).toBeNull();
  });

  test("a duration says no decimals it does not have", () => {
    expect(formatDuration(24)).toBe("24 s");
    expect(formatDuration(1.5)).toBe("1.5 s");
  });
});

test("an angle reads in degrees", () => {
  expect(formatAngle(Math.PI / 6)).toBe("30°");
});
