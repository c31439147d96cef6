import { secondsPerCount, type Tempo } from "../../document/counts";
import { LIMITS } from "../../document/limits";
import { parseInstant, parseLength, parseNumber, parseSpan, parseTime } from "../../document/parse";
import type { Units } from "../../document/scene";
import { formatNumber, formatTime, metersPer } from "../../document/units";
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

/** A part of a whole. */
export const SHARE: Quantity = {
  min: 0,
  max: 1,
  step: 0.05,
  scale: "linear",
  unit: "",
  format: (value) => value.toFixed(2),
  parse: parseNumber,
};

/** How much the two bases meet halfway. */
export const SHARING = SHARE;

/** An instant of the show, in scene seconds. */
export function instantQuantity(tempo: Tempo): Quantity {
  return {
    ...spanQuantity(tempo, { min: 0, max: LIMITS.seconds }),
    unit: "",
    format: formatTimeExactly,
    parse: (text) => parseInstant(text, tempo),
  };
}

/** How long something lasts, in seconds; counts and bars can be typed as well. */
export function spanQuantity(tempo: Tempo, bounds: { min: number; max: number }): Quantity {
  return {
    ...bounds,
    step: 0.1,
    scale: "linear",
    unit: "s",
    format: (value) => String(Number(value.toFixed(3))),
    parse: (text) => parseSpan(text, tempo),
  };
}

/** The same in counts, for those who read them; a bare number is counts. */
export function countsQuantity(tempo: Tempo, bounds: { min: number; max: number }): Quantity {
  const per = secondsPerCount(tempo);
  return {
    min: bounds.min / per,
    max: bounds.max / per,
    step: 1,
    scale: "linear",
    unit: "counts",
    format: (value) => String(Number(value.toFixed(2))),
    parse(text) {
      const counts = parseNumber(text);
      if (counts !== null) return counts;
      const seconds = parseSpan(text, tempo);
      return seconds === null ? null : seconds / per;
    },
  };
}

/** How fast a smooth join runs through its keyframes: at 0 it comes to rest in each, at 1 it swings out wide. */
export const TENSION = SHARE;
/** The tension of a Catmull-Rom spline. */
export const USUAL_TENSION = 0.5;

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

/** Hundredths and below are shown only where there are any. */
function formatTimeExactly(seconds: number): string {
  const tenths = formatTime(seconds);
  const rest = Math.round((seconds - (parseTime(tenths) ?? seconds)) * 1000);
  return rest === 0 ? tenths : `${tenths}${String(rest).padStart(2, "0")}`.replace(/0+$/, "");
}
