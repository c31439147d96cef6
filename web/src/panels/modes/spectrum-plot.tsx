import type { ModeBasis } from "../../engine/modes";

/** CSS pixels of the inspector's column; the slider below has the same ends. */
const WIDTH = 272;
const HEIGHT = 64;
/** Half the slider's thumb: its middle reaches so far from either end. */
const INSET = 8;
const DOT = 2;

/** Eigenvalues as stems over the slider that walks through them: those in use firm, the one looked at with its head. */
export function SpectrumPlot({ basis, count }: { basis: ModeBasis; count: number }) {
  const shown = basis.shownCount;
  const greatest = Math.max(basis.eigenvalues[shown - 1] ?? 0, 1e-9);
  const x = (index: number) => INSET + ((WIDTH - 2 * INSET) * index) / Math.max(1, shown - 1);
  const y = (index: number) => HEIGHT - 1 - (HEIGHT - 6) * ((basis.eigenvalues[index] ?? 0) / greatest);
  const stems = (from: number, to: number) => {
    let path = "";
    for (let index = from; index < to; index += 1) path += `M${x(index).toFixed(1)} ${HEIGHT}V${y(index).toFixed(1)}`;
    return path;
  };
  return (
    <svg class="spectrum" viewBox={`0 0 ${WIDTH} ${HEIGHT}`} aria-hidden="true">
      <path class="spectrum-rest" d={stems(count, shown)} />
      <path class="spectrum-used" d={stems(0, count)} />
      <circle cx={x(count - 1)} cy={y(count - 1)} r={DOT + 1} />
    </svg>
  );
}
