import type { Units } from "../../document/scene";
import { lengthWithUnit } from "../../document/units";
import type { Clash, ClashFinder } from "../clashes";
import type { Frame } from "../frame";
import { drawAgent } from "./agents";
import { drawClashDistance, drawClashRing, PILLS } from "./clash-mark";
import { drawName, ROOMY_RADIUS, setNameStyle } from "./names";

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
  drawClashRing(context, palette, x, y, reach);
  context.globalAlpha = 0.12;
  context.fillStyle = palette.clash;
  context.fill();
  context.globalAlpha = 1;
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

/** The pill of a clash, the `index`-th of this frame. Answers whether there was room. */
function drawDistance(
  context: CanvasRenderingContext2D,
  frame: Frame,
  { a, b, distance }: Clash,
  minimum: number,
  units: Units,
  index: number,
): boolean {
  const { points, palette, size } = frame;
  const x = ((points[2 * a] ?? 0) + (points[2 * b] ?? 0)) / 2;
  const y = ((points[2 * a + 1] ?? 0) + (points[2 * b + 1] ?? 0)) / 2;
  if (!frame.sees(x, y, 0)) return false;
  const words = lengthWithUnit(distance, units);
  return drawClashDistance(context, palette, size, x, y, ringReach(frame, minimum), words, index);
}
