import { useLayoutEffect, useRef } from "preact/hooks";
import { formatNumber } from "../../document/units";
import type { ModeMatch } from "../../engine/modes";
import { usePalette } from "../timeline/use-paint";

interface LikenessMapProps {
  readonly name: string;
  readonly match: ModeMatch;
  /** Which of the orders, as the match lists them. */
  readonly order: number;
  /** Whether the transition goes by it. */
  readonly isUsed: boolean;
  /** Along the diagonal. */
  readonly mean: number;
  readonly least: number;
}

/** |SᵀT| with its columns in the order that pairs them: a cell a pair of modes, in ink by how alike they are. */
export function LikenessMap({ name, match, order, isUsed, mean, least }: LikenessMapProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const palette = usePalette();
  useLayoutEffect(() => {
    if (canvas.current) paint(canvas.current, match, order, palette.ink);
  }, [match, order, palette]);
  const words = `${formatNumber(mean)} on average, ${formatNumber(least)} at least`;
  return (
    <figure class={isUsed ? "likeness-map used" : "likeness-map"}>
      <canvas ref={canvas} role="img" aria-label={`${name}: paired modes are alike by ${words}`} />
      <figcaption>
        {name}
        {isUsed && <span class="unseen">, in use</span>} <span class="number unit">{formatNumber(mean)}</span>
      </figcaption>
    </figure>
  );
}

function paint(canvas: HTMLCanvasElement, match: ModeMatch, order: number, ink: string): void {
  const size = Math.max(1, match.shownCount);
  canvas.width = size;
  canvas.height = size;
  const context = canvas.getContext("2d");
  if (!context) return;
  const rgb = Number.parseInt(ink.slice(1), 16);
  const image = context.createImageData(size, size);
  const targets = match.targets(order);
  for (let row = 0; row < match.shownCount; row += 1) {
    for (let column = 0; column < match.shownCount; column += 1) {
      const amount = match.amount(row, targets[column] ?? 0);
      image.data.set([rgb >> 16, (rgb >> 8) & 255, rgb & 255, Math.round(255 * amount)], 4 * (row * size + column));
    }
  }
  context.putImageData(image, 0, 0);
}
