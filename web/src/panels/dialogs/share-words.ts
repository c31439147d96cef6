import type { Units } from "../../document/scene";
import { formatCount, lengthWithUnit } from "../../document/units";

/** Where links are cut, by characters. */
export interface LinkLimit {
  readonly name: string;
  /** Null where a link is never cut. */
  readonly characters: number | null;
}

export const LINK_LIMITS: readonly LinkLimit[] = [
  { name: "QR code", characters: 1200 },
  { name: "Discord", characters: 2000 },
  { name: "Slack", characters: 4000 },
  { name: "Browsers", characters: null },
];

/** Ends of the meter, characters. */
const SHORTEST = 300;
const LONGEST = 33_000;

/** Less than both is no reason to round: characters, and a share of the link. */
const LEAST_SAVING = 100;
const LEAST_SHARE = 0.1;

/** Where a length stands on the meter, 0..1, by its logarithm. */
export function meterPlace(characters: number): number {
  const share = Math.log(characters / SHORTEST) / Math.log(LONGEST / SHORTEST);
  return Math.min(1, Math.max(0, share));
}

/** True when a link of this length would be cut there. */
export function isPast(limit: LinkLimit, characters: number): boolean {
  return limit.characters !== null && characters > limit.characters;
}

/** Where a link of this length fits, in plain words. */
export function fitWords(characters: number): string {
  const cut = LINK_LIMITS.filter((limit) => isPast(limit, characters)).map(({ name }) => name);
  if (cut.length === 0) return "Pastes whole anywhere and fits a QR code.";
  if (cut.length === 1) return "Pastes whole into Discord and Slack. Too long for a QR code.";
  if (cut.length === 2) return "Pastes whole into Slack. Discord would cut it.";
  return "Any browser opens it. Discord and Slack would cut it, so send it by mail or save a file.";
}

/** What the shorter link saves, in words; null where that is not worth rounding for. Lengths of both links, characters. */
export function savingWords(exact: number, short: number): string | null {
  const saved = exact - short;
  if (saved < LEAST_SAVING || saved < exact * LEAST_SHARE) return null;
  return `saves ${formatCount(saved)} characters by rounding positions`;
}

/** How far rounding moves an agent, in words: 0 is exact. */
export function roundingWords(meters: number): string {
  if (meters <= 0) return "Positions are exact.";
  if (meters < 0.001) return "Positions are rounded by less than 1 mm.";
  if (meters < 0.01) return `Positions are rounded by up to ${Math.ceil(meters * 1000)} mm.`;
  if (meters < 1) return `Positions are rounded by up to ${Math.ceil(meters * 100)} cm.`;
  return `Positions are rounded by up to ${(Math.ceil(meters * 10) / 10).toFixed(1)} m.`;
}

/** Which keyframes fall below the minimum distance by rounding alone; empty when none does. */
export function brokenWords(names: readonly string[], minimumDistance: number, units: Units): string {
  if (names.length === 0) return "";
  const limit = lengthWithUnit(minimumDistance, units);
  const shown = names.slice(0, 3).join(", ");
  const more = names.length > 3 ? ` and ${formatCount(names.length - 3)} more` : "";
  return `Rounded, agents come nearer than ${limit} in ${shown}${more}.`;
}
