import type { Palette } from "../palette";
import { font } from "./text";

export interface PillStyle {
  readonly x: number;
  /** Of its middle. */
  readonly y: number;
  /** Which part of the pill is at x. */
  readonly align: "left" | "center";
  readonly height: number;
  readonly fill: string;
  readonly ink: string;
  readonly edge: string | null;
}

const PADDING = 7;

/** Words of 11 px on a rounded ground. Answers the pill's width in CSS pixels. */
export function drawPill(context: CanvasRenderingContext2D, palette: Palette, text: string, style: PillStyle): number {
  const width = pillWidth(context, palette, text);
  const left = style.align === "left" ? style.x : style.x - width / 2;
  context.fillStyle = style.fill;
  context.beginPath();
  context.roundRect(left, style.y - style.height / 2, width, style.height, 5);
  context.fill();
  if (style.edge) {
    context.lineWidth = 1;
    context.strokeStyle = style.edge;
    context.stroke();
  }
  context.fillStyle = style.ink;
  context.textAlign = "left";
  context.textBaseline = "middle";
  context.fillText(text, left + PADDING, style.y + 0.5);
  return width;
}

/** Of a pill with these words, CSS pixels. Leaves the context with its font. */
export function pillWidth(context: CanvasRenderingContext2D, palette: Palette, text: string): number {
  context.font = font(palette, 11);
  return context.measureText(text).width + 2 * PADDING;
}
