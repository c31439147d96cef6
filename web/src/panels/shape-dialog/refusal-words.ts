import type { Units } from "../../document/scene";
import { lengthWithUnit } from "../../document/units";
import type { EngineProblem } from "../../engine/api";

/**
 * Why a shape has no places, in a sentence.
 *
 * Places are looked for a little farther apart than the scene asks for, which nobody has typed: the sentence says what the scene says.
 *
 * @param minimumDistance of the scene, meters
 */
export function refusalWords({ what }: EngineProblem, minimumDistance: number, units: Units): string {
  const asked = `${lengthWithUnit(minimumDistance, units)} apart, with a little to spare`;
  const told = what.replace(/\d[\d.e-]* m apart/, asked);
  return `${told.charAt(0).toUpperCase()}${told.slice(1)}.`;
}
