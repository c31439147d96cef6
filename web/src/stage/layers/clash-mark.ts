import type { Size } from "../camera";
import type { Palette } from "../palette";
import { font } from "./text";

/** The worst clashes carry their distance; the others show their ring only. */
export const PILLS = 3;
const PILL_HEIGHT = 22;

/** Pills laid down in this frame: left, top, right, bottom of each, CSS pixels. */
const taken = new Float32Array(4 * PILLS);

/**
 * How far the ring about a pair reaches, all in one unit: as far as the minimum distance, but about no more than the two.
 *
 * The minimum alone may be larger than the stage. `least` is what their discs take.
 */
export function clashReach(minimum: number, distance: number, least: number): number {
  return Math.max(least, Math.min(minimum, distance + least));
}

/** The ring about a pair that is too close, CSS pixels; an ellipse where it is seen from the side. */
export function drawClashRing(
  context: CanvasRenderingContext2D,
  palette: Palette,
  x: number,
  y: number,
  reach: number,
  rise = reach,
): void {
  context.beginPath();
  context.ellipse(x, y, reach, rise, 0, 0, 2 * Math.PI);
  context.lineWidth = 5;
  context.strokeStyle = palette.sheet;
  context.stroke();
  context.lineWidth = 2;
  context.strokeStyle = palette.clash;
  context.stroke();
}

/** Where a pill may stand about its ring: right above, left above, right below, left below. */
const CORNERS = [
  [1, -1],
  [-1, -1],
  [1, 1],
  [-1, 1],
] as const;

/** The pill of a ring at the first corner with room, the `index`-th of this frame. Answers whether there was room. */
export function drawClashDistance(
  context: CanvasRenderingContext2D,
  palette: Palette,
  size: Size,
  x: number,
  y: number,
  reach: number,
  text: string,
  index: number,
): boolean {
  context.font = font(palette, 11);
  const width = context.measureText(text).width + 30;
  for (const [right, down] of CORNERS) {
    const pillX = x + right * 20;
    const pillY = y + down * (reach + 26);
    if (!hasRoom(size, pillX, pillY, width, index)) continue;
    const length = Math.hypot(pillX - x, pillY - y);
    context.lineWidth = 2;
    context.strokeStyle = palette.clash;
    context.beginPath();
    context.moveTo(x + ((pillX - x) / length) * reach, y + ((pillY - y) / length) * reach);
    context.lineTo(pillX, pillY);
    context.stroke();
    drawClashPill(context, palette, pillX - width / 2, pillY, width, text);
    return true;
  }
  return false;
}

/** Whether a pill is on the stage and clear of the `count` before it; it takes the place. */
function hasRoom(size: Size, x: number, y: number, width: number, count: number): boolean {
  const left = x - width / 2;
  const top = y - PILL_HEIGHT / 2;
  const right = left + width;
  const bottom = top + PILL_HEIGHT;
  if (left < 4 || top < 4 || right > size.width - 4 || bottom > size.height - 4) return false;
  for (let k = 0; k < 4 * count; k += 4) {
    const isBeside = right < (taken[k] ?? 0) || left > (taken[k + 2] ?? 0);
    const isAbove = bottom < (taken[k + 1] ?? 0) || top > (taken[k + 3] ?? 0);
    if (!isBeside && !isAbove) return false;
  }
  taken[4 * count] = left - 3;
  taken[4 * count + 1] = top - 3;
  taken[4 * count + 2] = right + 3;
  taken[4 * count + 3] = bottom + 3;
  return true;
}

function drawClashPill(
  context: CanvasRenderingContext2D,
  palette: Palette,
  left: number,
  y: number,
  width: number,
  text: string,
): void {
  context.fillStyle = palette.clash;
  context.beginPath();
  context.roundRect(left, y - PILL_HEIGHT / 2, width, PILL_HEIGHT, 6);
  context.fill();
  context.fillStyle = palette.onClash;
  context.textAlign = "left";
  context.textBaseline = "middle";
  context.fillText(text, left + 23, y + 0.5);
  drawBrokenWedge(context, left + 7, y);
}

/** The sign of a clash: a wedge cut by a bar. */
function drawBrokenWedge(context: CanvasRenderingContext2D, x: number, y: number): void {
  context.beginPath();
  context.moveTo(x, y - 0.6);
  context.lineTo(x + 4, y - 1.4);
  context.lineTo(x + 4, y + 1.4);
  context.lineTo(x, y + 0.6);
  context.closePath();
  context.rect(x + 5.4, y - 4.5, 1.3, 9);
  context.moveTo(x + 8, y - 1.8);
  context.lineTo(x + 12, y - 2.6);
  context.lineTo(x + 12, y + 2.6);
  context.lineTo(x + 8, y + 1.8);
  context.closePath();
  context.fill();
}
