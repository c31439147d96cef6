import type { Units } from "./scene";

/** Meters in one of each; a step is the marching step of 8 to 5 yards. */
const METERS: Readonly<Record<Units, number>> = { m: 1, ft: 0.3048, yd: 0.9144, steps: 0.5715 };

/** A true minus. */
export const MINUS = "−";

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

/** Meters in one unit. */
export function metersPer(units: Units): number {
  return METERS[units];
}

/** `0:05.3`, cut rather than rounded: a clock never runs ahead. */
export function formatTime(seconds: number): string {
  return formatTenths(tenthsAt(seconds));
}

/** Tenths of a second that a clock shows. */
export function tenthsAt(seconds: number): number {
  // 4.35 s × 10 is 43.499…: a keyframe set to 4.4 must not read 4.3.
  return Math.floor(Math.max(0, seconds) * 10 + 1e-6);
}

export function formatTenths(tenths: number): string {
  const whole = Math.floor(tenths / 10);
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, "0")}.${tenths % 10}`;
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
