import { LIMITS } from "../../document/limits";
import type { Units } from "../../document/scene";
import { formatNumber, metersPer, parseLength, parseNumber } from "../../document/units";
import type { Quantity } from "../controls/quantity";

/** Whether a unit is too long a word to stand in a small box. */
export function isLongUnit(units: Units): boolean {
  return units.length > 3;
}

/** A length in the scene's units. */
export function lengthQuantity(units: Units, bounds: { min: number; max: number; step: number }): Quantity {
  return {
    ...bounds,
    scale: "linear",
    unit: units,
    format: (value) => formatNumber(value),
    parse: (text) => {
      const meters = parseLength(text, units);
      return meters === null ? null : meters / metersPer(units);
    },
  };
}

/** A size, which reads without decimals that it does not have. */
export function sizeQuantity(units: Units): Quantity {
  const most = LIMITS.coordinate / metersPer(units);
  const quantity = lengthQuantity(units, { min: 0.1, max: most, step: 1 });
  return { ...quantity, format: (value) => String(Number(value.toFixed(2))) };
}

/** A coordinate: as far as a scene goes. */
export function coordinateQuantity(units: Units): Quantity {
  const most = LIMITS.coordinate / metersPer(units);
  return lengthQuantity(units, { min: -most, max: most, step: 0.1 });
}

/** How many times the proposed tie. */
export const FACTOR: Quantity = {
  min: 0.1,
  max: 100,
  step: 0.1,
  scale: "log",
  unit: "×",
  format: (value) => String(Number(value.toPrecision(3))),
  parse: (text) => parseNumber(text.replace(/[×x]/i, "")),
};

/** How much the two bases meet halfway. */
export const SHARING: Quantity = {
  min: 0,
  max: 1,
  step: 0.05,
  scale: "linear",
  unit: "",
  format: (value) => value.toFixed(2),
  parse: parseNumber,
};

export function secondsQuantity(max: number): Quantity {
  return {
    min: 0,
    max,
    step: 0.1,
    scale: "linear",
    unit: "s",
    format: (value) => String(Number(value.toFixed(3))),
    parse: (text) => parseNumber(text.replace(/\s*s$/i, "")),
  };
}

export function wholeQuantity(min: number, max: number, unit = ""): Quantity {
  return {
    min,
    max,
    step: 1,
    scale: "linear",
    unit,
    format: (value) => String(Number(value.toFixed(3))),
    parse: parseNumber,
  };
}
