import type { Frame } from "../frame";
import { clamp } from "../spacing";
import { drawPill, pillWidth } from "./pill";

/** Between a readout and the edge of the stage, CSS pixels. */
const EDGE = 8;
const HEIGHT = 18;

/** A number in the hand, on the person's own color, about `x`; pushed in where the stage ends. */
export function drawReadout(
  context: CanvasRenderingContext2D,
  { palette, size }: Frame,
  words: string,
  x: number,
  y: number,
): void {
  const reach = EDGE + pillWidth(context, palette, words) / 2;
  drawPill(context, palette, words, {
    x: clamp(x, reach, size.width - reach),
    y: Math.max(y, EDGE + HEIGHT / 2),
    align: "center",
    height: HEIGHT,
    fill: palette.you,
    ink: palette.onYou,
    edge: null,
  });
}
