import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { formatNumber, formatTime } from "../../document/units";
import { fractionOf, type Quantity, rangeWords, stepped, stepsOf, valueAt, withUnit } from "./quantity";

const words = { format: String, parse: Number, unit: "" };
const weight: Quantity = { min: 0.1, max: 100, step: 1, scale: "log", ...words };
const sharing: Quantity = { min: 0, max: 1, step: 0.01, scale: "linear", ...words };

describe("a slider of weights", () => {
  test("the proposed weight sits a third of the way, ten times it two thirds", () => {
    expect(fractionOf(weight, 1)).toBeCloseTo(1 / 3, 12);
    expect(fractionOf(weight, 10)).toBeCloseTo(2 / 3, 12);
  });

  test("the ends are reached exactly and never passed", () => {
    expect(valueAt(weight, -1)).toBe(0.1);
    expect(valueAt(weight, 2)).toBe(100);
  });

  test("every step changes the number, down to the end and up to the end", () => {
    let value = 0.1;
    for (let count = 0; value < 100; count += 1) {
      const next = stepped(weight, value, 1);
      expect(next).toBeGreaterThan(value);
      expect(count).toBeLessThan(200);
      value = next;
    }
    expect(stepped(weight, value, 1)).toBe(100);
  });
});

test("a linear slider stands on its steps wherever the pointer is", () => {
  fc.assert(
    fc.property(fc.double({ min: 0, max: 1, noNaN: true }), (fraction) => {
      const value = valueAt(sharing, fraction);
      expect(Math.abs(value * 100 - Math.round(value * 100))).toBeLessThan(1e-9);
      // Half a step, and round-off of the product.
      expect(Math.abs(value - fraction)).toBeLessThanOrEqual(0.005 + 1e-9);
    }),
  );
});

test("shift takes ten steps at once", () => {
  expect(stepsOf({ key: "ArrowUp", shiftKey: true })).toBe(10);
  expect(stepsOf({ key: "a", shiftKey: false })).toBeNull();
});

test("what is admissible is said with thousands apart and the unit", () => {
  expect(rangeWords({ ...weight, unit: "×" })).toBe("Between 0.1 and 100 ×");
  expect(rangeWords({ ...sharing, min: -1000, max: 12345.5 })).toBe("Between -1,000 and 12,345.5");
  const length: Quantity = {
    ...sharing,
    min: -100_000,
    max: 100_000,
    unit: "m",
    format: (value) => formatNumber(value),
  };
  expect(rangeWords(length)).toBe("Between −100,000 and 100,000 m");
  expect(withUnit(length, -1234.5)).toBe("−1,234.50 m");
  expect(rangeWords({ ...sharing, max: 3600, format: formatTime })).toBe("Between 0:00.0 and 60:00.0");
});
