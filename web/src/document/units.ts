import type { Units } from "./scene";

/** Meters in one of each; a step is the marching step of 8 to 5 yards. */
const METERS: Readonly<Record<Units, number>> = { m: 1, ft: 0.3048, yd: 0.9144, steps: 0.5715 };

const SPELLINGS: Readonly<Record<string, Units>> = {
  m: "m",
  meter: "m",
  meters: "m",
  ft: "ft",
  foot: "ft",
  feet: "ft",
  "'": "ft",
  "′": "ft",
  yd: "yd",
  yard: "yd",
  yards: "yd",
  step: "steps",
  steps: "steps",
};

const MINUS = "−";

/** A number as the page writes it: a true minus, and never a minus zero. */
export function formatNumber(value: number, decimals = 2): string {
  const text = Math.abs(value).toFixed(decimals);
  return value < 0 && Number(text) !== 0 ? MINUS + text : text;
}

/** What a length reads as in the scene's units, without the unit. */
export function formatLength(meters: number, units: Units, decimals = 2): string {
  return formatNumber(meters / METERS[units], decimals);
}

/** `0.57 m` */
export function lengthWithUnit(meters: number, units: Units, decimals = 2): string {
  return `${formatLength(meters, units, decimals)} ${units}`;
}

/** A length as a person types it, in the scene's units unless it names its own; meters, or null when it is none. */
export function parseLength(text: string, units: Units): number | null {
  const match = /^\s*([+\-−]?[\d.,]+(?:e[+-]?\d+)?)\s*([a-z'′]*)\s*$/i.exec(text);
  if (!match) return null;
  const [, number = "", unit = ""] = match;
  const value = parseNumber(number);
  const named = unit === "" ? units : SPELLINGS[unit.toLowerCase()];
  return value === null || named === undefined ? null : value * METERS[named];
}

/** A number as a person types it, with a point or a comma before the decimals; null when it is none. */
export function parseNumber(text: string): number | null {
  const plain = text
    .trim()
    .replace(MINUS, "-")
    .replace(/^([^.,]*),([^.,]*)$/, "$1.$2");
  if (!/\d/.test(plain)) return null;
  const value = Number(plain);
  return Number.isFinite(value) ? value : null;
}

/** Meters in one unit. */
export function metersPer(units: Units): number {
  return METERS[units];
}

/** `0:05.3`, cut rather than rounded: a clock never runs ahead. */
export function formatTime(seconds: number): string {
  // 4.35 s × 10 is 43.499…: a keyframe set to 4.4 must not read 4.3.
  const tenths = Math.floor(Math.max(0, seconds) * 10 + 1e-6);
  const whole = Math.floor(tenths / 10);
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, "0")}.${tenths % 10}`;
}

/** Seconds from `5.3`, `0:05.3` or `1:02:03`; null when it is no time. */
export function parseTime(text: string): number | null {
  const parts = text.trim().replace(/\s*s$/, "").split(":");
  if (parts.length > 3) return null;
  let seconds = 0;
  for (const [index, part] of parts.entries()) {
    const value = parseNumber(part);
    if (value === null || value < 0 || (index > 0 && value >= 60)) return null;
    seconds = seconds * 60 + value;
  }
  return seconds;
}

/** `24 s`, `1.5 s`: how long something lasts. */
export function formatDuration(seconds: number): string {
  return `${Number(seconds.toFixed(1))} s`;
}

/** `1,260` */
export function formatCount(count: number): string {
  return count.toLocaleString("en-US");
}

/** `21°` from radians. */
export function formatAngle(radians: number): string {
  return `${formatNumber((radians * 180) / Math.PI, 0)}°`;
}
