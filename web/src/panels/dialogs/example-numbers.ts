import { formatNumber } from "../../document/units";
import type { ExampleView, Preview } from "./services";

/**
 * What an example comes to in a line: how near anybody comes to another, and how far ties leave their due lengths on average.
 *
 * Of ways side by side each has its own numbers; else they are those of the whole show.
 */
export function numbersOf({ leastDistances, distortions }: Preview, view: ExampleView | undefined): string {
  if (leastDistances.length === 0 || distortions.length === 0) return "";
  if (view?.kind === "compare" && !view.preset) {
    const each = (values: readonly number[]) =>
      view.segments.map((segment) => formatNumber(values[segment] ?? Number.NaN)).join(", then ");
    return `Nearest ${each(leastDistances)} m; distortion ${each(distortions)}`;
  }
  const mean = distortions.reduce((sum, value) => sum + value, 0) / distortions.length;
  return `Nearest ${formatNumber(Math.min(...leastDistances))} m; distortion ${formatNumber(mean)}`;
}
