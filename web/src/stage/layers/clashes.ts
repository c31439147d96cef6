import type { Units } from "../../document/scene";
import { lengthWithUnit } from "../../document/units";
import type { Clash, ClashFinder } from "../clashes";
import type { Frame } from "../frame";
import { drawAgent } from "./agents";
import { drawName, ROOMY_RADIUS, setNameStyle } from "./names";
import { font } from "./text";

/** The worst clashes carry their distance; the others show their ring only. */
const PILLS = 3;
const PILL_HEIGHT = 22;

/** Rings about pairs that are too close, with the pair on top and the distance of the worst. */
export function drawClashes(
  context: CanvasRenderingContext2D,
  frame: Frame,
  clashes: ClashFinder,
  minimum: number,
  units: Units,
): void {
  // The worst come first in the list and are drawn last, on top.
  for (let k = clashes.count - 1; k >= 0; k -= 1) {
    const clash = clashes.found[k];
    if (clash) drawClash(context, frame, clash, minimum, k < PILLS ? units : null);
  }
}

function drawClash(
  context: CanvasRenderingContext2D,
  frame: Frame,
  { a, b, distance }: Clash,
  minimum: number,
  units: Units | null,
): void {
  const { palette, points, radius } = frame;
  const x = ((points[2 * a] ?? 0) + (points[2 * b] ?? 0)) / 2;
  const y = ((points[2 * a + 1] ?? 0) + (points[2 * b + 1] ?? 0)) / 2;
  const reach = Math.max(radius + 6, minimum * frame.camera.scale);
  if (!frame.sees(x, y, reach)) return;
  context.beginPath();
  context.arc(x, y, reach, 0, 2 * Math.PI);
  context.lineWidth = 5;
  context.strokeStyle = palette.sheet;
  context.stroke();
  context.globalAlpha = 0.12;
  context.fillStyle = palette.clash;
  context.fill();
  context.globalAlpha = 1;
  context.lineWidth = 2;
  context.strokeStyle = palette.clash;
  context.stroke();
  drawAgent(context, frame, a);
  drawAgent(context, frame, b);
  if (radius >= ROOMY_RADIUS) {
    setNameStyle(context, frame);
    drawName(context, frame, a);
    drawName(context, frame, b);
  }
  if (units) drawDistance(context, frame, x, y, reach, lengthWithUnit(distance, units));
}

/** The pill above the ring, below it where there is no room. */
function drawDistance(
  context: CanvasRenderingContext2D,
  frame: Frame,
  x: number,
  y: number,
  reach: number,
  text: string,
): void {
  const { palette, size } = frame;
  const side = y - reach - 40 < 0 ? 1 : -1;
  context.font = font(palette, 11);
  const width = context.measureText(text).width + 30;
  const pillX = Math.min(Math.max(x + 20, width / 2 + 4), size.width - width / 2 - 4);
  const pillY = y + side * (reach + 26);
  const length = Math.hypot(pillX - x, pillY - y);
  context.lineWidth = 2;
  context.strokeStyle = palette.clash;
  context.beginPath();
  context.moveTo(x + ((pillX - x) / length) * reach, y + ((pillY - y) / length) * reach);
  context.lineTo(pillX, pillY);
  context.stroke();
  const left = pillX - width / 2;
  context.fillStyle = palette.clash;
  context.beginPath();
  context.roundRect(left, pillY - PILL_HEIGHT / 2, width, PILL_HEIGHT, 6);
  context.fill();
  context.fillStyle = palette.onClash;
  context.textAlign = "left";
  context.textBaseline = "middle";
  context.fillText(text, left + 23, pillY + 0.5);
  drawBrokenWedge(context, left + 7, pillY);
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
