import { formatTime } from "../../document/units";

/** `0:14`: a time with tenths only where there are any. */
export function shortTime(seconds: number): string {
  const text = formatTime(seconds);
  return text.endsWith(".0") ? text.slice(0, -2) : text;
}
