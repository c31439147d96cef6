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

/** Pills laid down in this frame: left, top, right, bottom of each, CSS pixels. */
const taken = new Float32Array(4 * PILLS);

/** Rings about pairs that are too close, with the pair on top and the distance of the worst. */
export function drawClashes(
  context: CanvasRenderingContext2D,
  frame: Frame,
  clashes: ClashFinder,
  minimum: number,
  units: Units,
): void {
  for (let k = clashes.count - 1; k >= 0; k -= 1) {
    const clash = clashes.found[k];
    if (clash) drawRing(context, frame, clash, minimum);
  }
  let pills = 0;
  for (let k = 0; k < clashes.count && pills < PILLS; k += 1) {
    const clash = clashes.found[k];
    if (clash && drawDistance(context, frame, clash, minimum, units, pills)) pills += 1;
  }
}

function drawRing(context: CanvasRenderingContext2D, frame: Frame, { a, b }: Clash, minimum: number): void {
  const { palette, points, radius } = frame;
  const x = ((points[2 * a] ?? 0) + (points[2 * b] ?? 0)) / 2;
  const y = ((points[2 * a + 1] ?? 0) + (points[2 * b + 1] ?? 0)) / 2;
  const reach = ringReach(frame, minimum);
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
}

function ringReach(frame: Frame, minimum: number): number {
  return Math.max(frame.radius + 6, minimum * frame.camera.scale);
}

/** Where a pill may stand about its ring: right above, left above, right below, left below. */
const CORNERS = [
  [1, -1],
  [-1, -1],
  [1, 1],
  [-1, 1],
] as const;

/** The pill of a clash at the first corner with room, the `index`-th of this frame. Answers whether there was room. */
function drawDistance(
  context: CanvasRenderingContext2D,
  frame: Frame,
  { a, b, distance }: Clash,
  minimum: number,
  units: Units,
  index: number,
): boolean {
  const { points } = frame;
  const x = ((points[2 * a] ?? 0) + (points[2 * b] ?? 0)) / 2;
  const y = ((points[2 * a + 1] ?? 0) + (points[2 * b + 1] ?? 0)) / 2;
  if (!frame.sees(x, y, 0)) return false;
  const reach = ringReach(frame, minimum);
  const text = lengthWithUnit(distance, units);
  context.font = font(frame.palette, 11);
  const width = context.measureText(text).width + 30;
  for (const [right, down] of CORNERS) {
    const pillX = x + right * 20;
    const pillY = y + down * (reach + 26);
    if (!hasRoom(frame, pillX, pillY, width, index)) continue;
    const length = Math.hypot(pillX - x, pillY - y);
    context.lineWidth = 2;
    context.strokeStyle = frame.palette.clash;
    context.beginPath();
    context.moveTo(x + ((pillX - x) / length) * reach, y + ((pillY - y) / length) * reach);
    context.lineTo(pillX, pillY);
    context.stroke();
    drawClashPill(context, frame, pillX - width / 2, pillY, width, text);
    return true;
  }
  return false;
}

/** Whether a pill is on the stage and clear of the `count` before it; it takes the place. */
function hasRoom({ size }: Frame, x: number, y: number, width: number, count: number): boolean {
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
  { palette }: Frame,
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
