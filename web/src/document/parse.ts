import { secondsPerCount, type Tempo, timeOfCount } from "./counts";
import type { Units } from "./scene";
import { MINUS, metersPer } from "./units";

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

/** A length as a person types it, in the scene's units unless it names its own; meters, or null when it is none. */
export function parseLength(text: string, units: Units): number | null {
  const match = /^\s*([+\-−]?[\d.,]+(?:e[+-]?\d+)?)\s*([a-z'′]*)\s*$/i.exec(text);
  if (!match) return null;
  const [, number = "", unit = ""] = match;
  const value = parseNumber(number);
  const named = unit === "" ? units : SPELLINGS[unit.toLowerCase()];
  return value === null || named === undefined ? null : value * metersPer(named);
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

/** How long something lasts: `16 counts`, `8 c`, `2 bars`, `1 bar 2 counts`, or a time; seconds, null when it is none. */
export function parseSpan(text: string, tempo: Tempo): number | null {
  return parseCounts(text, tempo) ?? parseTime(text);
}

/** An instant: `bar 5`, `bar 5.3`, so many counts or bars after the first count, or a time; scene seconds or null. */
export function parseInstant(text: string, tempo: Tempo): number | null {
  const bar = /^\s*bar\s+(\d+)(?:[.:](\d+))?\s*$/i.exec(text);
  if (bar) {
    const [number, count] = [Number(bar[1]), Number(bar[2] ?? 1)];
    if (number < 1 || count < 1 || count > tempo.beatsPerBar) return null;
    return timeOfCount(tempo, (number - 1) * tempo.beatsPerBar + count - 1);
  }
  const counts = parseCounts(text, tempo);
  return counts === null ? parseTime(text) : tempo.start + counts;
}

/** Seconds of a length in bars and counts; null when it names neither. */
function parseCounts(text: string, tempo: Tempo): number | null {
  const match = /^\s*(?:([\d.,]+)\s*b(?:ars?)?)?\s*(?:([\d.,]+)\s*(?:c(?:ounts?)?|beats?))?\s*$/i.exec(text);
  if (!match || (match[1] === undefined && match[2] === undefined)) return null;
  const [bars, counts] = [parseNumber(match[1] ?? "0"), parseNumber(match[2] ?? "0")];
  return bars === null || counts === null ? null : (bars * tempo.beatsPerBar + counts) * secondsPerCount(tempo);
}
