/** What a shape is read from: red, green, blue and opacity, row by row from the top. */
export interface Pixels {
  /** Pixels in a row. */
  readonly width: number;
  readonly rgba: Uint8ClampedArray;
  /** What the person should know of it; empty when there is nothing. */
  readonly note: string;
}

/** Why there is nothing to read a shape from: a sentence. */
export class NoPixels extends Error {}

/** What to give first: a sentence, and no mistake of anybody. */
export class NothingYet extends Error {}

/** Pixels of the longer side: what tells 5,000 places in a shape apart. */
export const SIDE = 640;

/** What is drawn on an empty canvas. */
export function drawnPixels(
  width: number,
  height: number,
  draw: (context: CanvasRenderingContext2D) => void,
  note = "",
): Pixels {
  const canvas = document.createElement("canvas");
  canvas.width = Math.max(1, Math.round(width));
  canvas.height = Math.max(1, Math.round(height));
  const context = canvas.getContext("2d", { willReadFrequently: true });
  if (!context) throw new NoPixels("This browser gives no canvas to draw on.");
  draw(context);
  const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
  return { width: canvas.width, rgba: data, note };
}
