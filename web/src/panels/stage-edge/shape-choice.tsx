import { useId } from "preact/hooks";
import type { ShapeName } from "../../tools/toolbox";
import { useStudio } from "../studio";

type Dots = readonly (readonly [x: number, y: number])[];

const SHAPES: readonly { readonly shape: ShapeName; readonly name: string; readonly dots: Dots }[] = [
  { shape: "line", name: "Line", dots: range(5).map((i) => [3 + i * 3.5, 17 - i * 3.5]) },
  { shape: "arc", name: "Arc", dots: around(6, 7.5, Math.PI, 2 * Math.PI, 14) },
  { shape: "circle", name: "Circle", dots: around(9, 7, 0, (16 * Math.PI) / 9) },
  {
    shape: "ring",
    name: "Ring",
    dots: [...around(11, 7.6, 0, (20 * Math.PI) / 11), ...around(6, 4, 0, (10 * Math.PI) / 6)],
  },
  { shape: "block", name: "Block", dots: lattice(4, 3, 4.2, 4.2) },
  { shape: "grid", name: "Grid", dots: lattice(4, 4, 4.6, 4.6) },
  {
    shape: "triangle",
    name: "Triangle",
    dots: range(4).flatMap((row) => range(row + 1).map((i) => [10 + (i - row / 2) * 4.4, 4 + row * 4.2] as const)),
  },
  {
    shape: "star",
    name: "Star",
    dots: range(10).map((i) => at(i % 2 === 0 ? 8 : 3.6, (i * Math.PI) / 5 - Math.PI / 2, 10.5)),
  },
];

/** Which shape to draw, each shown by the agents in it. */
export function ShapeChoice() {
  const { toolbox } = useStudio();
  const name = useId();
  return (
    <div class="shape-choice" role="radiogroup" aria-label="Shape">
      {SHAPES.map((entry) => (
        <label key={entry.shape} data-tip={entry.name} data-tip-side="top">
          <input
            type="radio"
            class="overlaid"
            name={name}
            aria-label={entry.name}
            value={entry.shape}
            checked={entry.shape === toolbox.shape.value}
            onChange={() => {
              toolbox.shape.value = entry.shape;
            }}
          />
          <svg viewBox="0 0 20 20" width="20" height="20" aria-hidden="true">
            {entry.dots.map(([x, y]) => (
              <circle key={`${x} ${y}`} cx={x} cy={y} r="1.35" />
            ))}
          </svg>
        </label>
      ))}
    </div>
  );
}

function range(count: number): number[] {
  return Array.from({ length: count }, (_, index) => index);
}

function at(radius: number, angle: number, middle = 10): readonly [number, number] {
  return [10 + radius * Math.cos(angle), middle + radius * Math.sin(angle)];
}

/** Evenly from one angle to another, both included. */
function around(count: number, radius: number, from: number, to: number, middle = 10): Dots {
  return range(count).map((i) => at(radius, from + ((to - from) * i) / (count - 1), middle));
}

function lattice(columns: number, rows: number, dx: number, dy: number): Dots {
  return range(rows).flatMap((row) =>
    range(columns).map((column) => [10 + (column - (columns - 1) / 2) * dx, 10 + (row - (rows - 1) / 2) * dy] as const),
  );
}
