import type { Units } from "../../document/scene";
import { formatCount, lengthWithUnit } from "../../document/units";
import type { EngineProblem } from "../../engine/api";

/**
 * Why a shape has no places, in a sentence.
 *
 * Places are looked for a little farther apart than the scene asks for, which nobody has typed: the sentence says what the scene says.
 *
 * @param minimumDistance of the scene, meters
 */
export function refusalWords({ what, tooCrowded }: EngineProblem, minimumDistance: number, units: Units): string {
  if (!tooCrowded) return `${what.charAt(0).toUpperCase()}${what.slice(1)}.`;
  const { count, largest } = tooCrowded;
  const apart = `${lengthWithUnit(minimumDistance, units)} apart, with a little to spare`;
  const fitting = `${formatCount(largest)} ${largest === 1 ? "does" : "do"}`;
  return `${formatCount(count)} agents do not fit ${apart}; ${fitting}. Ask for fewer, a larger shape or a smaller minimum distance.`;
}
