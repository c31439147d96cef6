import { formatCount } from "../../document/units";

/** A number a person sets: its bounds, how it is written and read, and how far a step goes. */
export interface Quantity {
  readonly min: number;
  readonly max: number;
  readonly step: number;
  /** Logarithmic: every step multiplies. */
  readonly scale: "linear" | "log";
  format(value: number): string;
  /** Null when the text is no such number. */
  parse(text: string): number | null;
  /** Shown after the number. */
  readonly unit: string;
}

const PLAIN = /^([-−]?)(\d+)((?:\.\d+)?)$/;
/** Decimals of nothing; the seconds of a time are none. */
const NO_DECIMALS = /^([-−]?[\d,]+)\.0+$/;

/** Steps from one end of a logarithmic scale to the other. */
const LOG_STEPS = 60;

export function clampTo(quantity: Pick<Quantity, "min" | "max">, value: number): number {
  return Math.min(quantity.max, Math.max(quantity.min, value));
}

/** What is admissible, for somebody whose number was corrected: `Between 1 and 5,000`. */
export function rangeWords({ min, max, unit, format }: Quantity): string {
  const bound = (value: number) => grouped(format(value)).replace(NO_DECIMALS, "$1");
  return `Between ${bound(min)} and ${bound(max)} ${unit}`.trim();
}

/** For somebody who asked for more than the scene allows; `value` as it is written, with its unit. */
export function asNear(value: string): string {
  return `As near as it can be: ${value}`;
}

/** A value as it is written, with its unit. */
export function withUnit({ unit, format }: Quantity, value: number): string {
  return `${grouped(format(value))} ${unit}`.trim();
}

/** A number with its thousands apart; what is more than a number, such as a time, as it is. */
function grouped(written: string): string {
  return written.replace(PLAIN, (_, sign: string, whole: string, decimals: string) => {
    return sign + formatCount(Number(whole)) + decimals;
  });
}

/** Where a value is between the ends, 0..1. */
export function fractionOf(quantity: Quantity, value: number): number {
  const clamped = clampTo(quantity, value);
  const { min, max } = quantity;
  if (max <= min) return 0;
  return quantity.scale === "log" ? Math.log(clamped / min) / Math.log(max / min) : (clamped - min) / (max - min);
}

/** The value at a fraction of the way, on the nearest step; logarithmic ones on two significant digits. */
export function valueAt(quantity: Quantity, fraction: number): number {
  const { min, max, step } = quantity;
  const t = Math.min(1, Math.max(0, fraction));
  if (quantity.scale === "log") return clampTo(quantity, Number((min * (max / min) ** t).toPrecision(2)));
  return clampTo(quantity, Number((min + Math.round(((max - min) * t) / step) * step).toFixed(10)));
}

/** One or more steps on, where the person expects round numbers. */
export function stepped(quantity: Quantity, value: number, steps: number): number {
  if (quantity.scale === "log") return valueAt(quantity, fractionOf(quantity, value) + steps / LOG_STEPS);
  return clampTo(quantity, Number((value + steps * quantity.step).toFixed(10)));
}

/** Steps a key asks for; null for keys that do not change a number. */
export function stepsOf(event: Pick<KeyboardEvent, "key" | "shiftKey">): number | null {
  const coarse = event.shiftKey ? 10 : 1;
  switch (event.key) {
    case "ArrowUp":
    case "ArrowRight":
      return coarse;
    case "ArrowDown":
    case "ArrowLeft":
      return -coarse;
    case "PageUp":
      return 10;
    case "PageDown":
      return -10;
    default:
      return null;
  }
}
