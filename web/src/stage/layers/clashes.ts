import type { Units } from "../../document/scene";
import { lengthWithUnit } from "../../document/units";
import type { Clash, ClashFinder } from "../clashes";
import type { Frame } from "../frame";
import { drawAgent } from "./agents";
import { clashReach, drawClashDistance, drawClashRing, PILLS } from "./clash-mark";
import { drawName, ROOMY_RADIUS, setNameStyle } from "./names";

/** More rings than this lie on one another, and hide who is in them. */
const MOST_RINGS = 12;
/** Of a heap the nearest so many pairs are joined; the timeline tells the rest. */
const MOST_LINKS = 48;
/** Between a disc and the ring about it, CSS pixels. */
const GAP = 6;

/** Rings about pairs that are too close, of a heap a line between the two; the agents on top, and the distance of the worst. */
export function drawClashes(
  context: CanvasRenderingContext2D,
  frame: Frame,
  clashes: ClashFinder,
  minimum: number,
  units: Units,
): void {
  const isHeap = clashes.count > MOST_RINGS;
  if (isHeap) drawHeap(context, frame, clashes);
  for (let k = clashes.count - 1; k >= 0 && !isHeap; k -= 1) {
    const clash = clashes.found[k];
    if (clash) drawRing(context, frame, clash, minimum);
  }
  const mostPills = isHeap ? 1 : PILLS;
  let pills = 0;
  for (let k = 0; k < clashes.count && pills < mostPills; k += 1) {
    const clash = clashes.found[k];
    if (!clash) continue;
    const reach = isHeap ? 0 : ringReach(frame, clash, minimum);
    if (drawDistance(context, frame, clash, reach, units, pills)) pills += 1;
  }
}

function drawHeap(context: CanvasRenderingContext2D, frame: Frame, clashes: ClashFinder): void {
  const { palette, points } = frame;
  const count = Math.min(clashes.count, MOST_LINKS);
  context.beginPath();
  for (let k = 0; k < count; k += 1) {
    const clash = clashes.found[k];
    if (!clash) continue;
    const { a, b } = clash;
    context.moveTo(points[2 * a] ?? 0, points[2 * a + 1] ?? 0);
    context.lineTo(points[2 * b] ?? 0, points[2 * b + 1] ?? 0);
    traceTight(context, frame, a);
    traceTight(context, frame, b);
  }
  context.lineWidth = 2;
  context.strokeStyle = palette.clash;
  context.stroke();
  for (let k = count - 1; k >= 0; k -= 1) {
    const clash = clashes.found[k];
    if (clash) drawPair(context, frame, clash);
  }
}

/** A ring close about one agent, added to the path. */
function traceTight(context: CanvasRenderingContext2D, { points, radius }: Frame, agent: number): void {
  const x = points[2 * agent] ?? 0;
  const y = points[2 * agent + 1] ?? 0;
  context.moveTo(x + radius + GAP / 2, y);
  context.arc(x, y, radius + GAP / 2, 0, 2 * Math.PI);
}

function drawRing(context: CanvasRenderingContext2D, frame: Frame, clash: Clash, minimum: number): void {
  const { a, b } = clash;
  const { palette, points } = frame;
  const x = ((points[2 * a] ?? 0) + (points[2 * b] ?? 0)) / 2;
  const y = ((points[2 * a + 1] ?? 0) + (points[2 * b + 1] ?? 0)) / 2;
  const reach = ringReach(frame, clash, minimum);
  if (!frame.sees(x, y, reach)) return;
  drawClashRing(context, palette, x, y, reach);
  context.globalAlpha = 0.12;
  context.fillStyle = palette.clash;
  context.fill();
  context.globalAlpha = 1;
  drawPair(context, frame, clash);
}

function drawPair(context: CanvasRenderingContext2D, frame: Frame, { a, b }: Clash): void {
  drawAgent(context, frame, a);
  drawAgent(context, frame, b);
  if (frame.radius < ROOMY_RADIUS) return;
  setNameStyle(context, frame);
  drawName(context, frame, a);
  drawName(context, frame, b);
}

function ringReach({ camera, radius }: Frame, { distance }: Clash, minimum: number): number {
  return clashReach(minimum * camera.scale, distance * camera.scale, radius + GAP);
}

/** The pill of a clash, the `index`-th of this frame. Answers whether there was room. */
function drawDistance(
  context: CanvasRenderingContext2D,
  frame: Frame,
  { a, b, distance }: Clash,
  reach: number,
  units: Units,
  index: number,
): boolean {
  const { points, palette, size } = frame;
  const x = ((points[2 * a] ?? 0) + (points[2 * b] ?? 0)) / 2;
  const y = ((points[2 * a + 1] ?? 0) + (points[2 * b + 1] ?? 0)) / 2;
  if (!frame.sees(x, y, 0)) return false;
  const words = lengthWithUnit(distance, units);
  return drawClashDistance(context, palette, size, x, y, reach, words, index);
}
