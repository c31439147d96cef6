import type { ScreenPoint } from "../camera";
import type { Frame } from "../frame";
import { handlePlace, handlesOf, SCALE_HANDLES, type SelectionBox } from "../handles";
import type { Lifts } from "../lifts";

/** Rings about the selected agents. */
export function drawRings(context: CanvasRenderingContext2D, frame: Frame, agents: Iterable<number>): void {
  const { palette, radius, points } = frame;
  const isLarge = radius > 6;
  context.lineWidth = isLarge ? 2 : 1.5;
  const reach = radius + (isLarge ? 2.5 : 1.5) + context.lineWidth / 2 - 0.5;
  context.strokeStyle = palette.you;
  context.beginPath();
  for (const agent of agents) {
    const x = points[2 * agent] ?? 0;
    const y = points[2 * agent + 1] ?? 0;
    if (!frame.sees(x, y, reach)) continue;
    context.moveTo(x + reach, y);
    context.arc(x, y, reach, 0, 2 * Math.PI);
  }
  context.stroke();
}

/** The ring of an agent under the pointer: slimmer than a selected one's. */
export function drawHoverRing(context: CanvasRenderingContext2D, frame: Frame, agent: number): void {
  context.globalAlpha = 0.55;
  drawRings(context, frame, [agent]);
  context.globalAlpha = 1;
}

/**
 * The box about a selection with its handles: squares scale, the circle turns, the capsule lifts.
 *
 * @param lifted how far above its place the handle to lift is held, CSS pixels
 */
export function drawBox(
  context: CanvasRenderingContext2D,
  frame: Frame,
  box: SelectionBox,
  lifts: Lifts,
  lifted: number,
): void {
  const { palette } = frame;
  const handles = handlesOf(box, lifts);
  context.strokeStyle = palette.you;
  context.fillStyle = palette.sheet;
  if (!box.isSpot) {
    context.lineWidth = 1;
    context.strokeRect(box.left, box.top, box.right - box.left, box.bottom - box.top);
    drawTurn(context, handlePlace(box, "rotate"), box.top);
    context.beginPath();
    for (const handle of SCALE_HANDLES) {
      const { x, y } = handlePlace(box, handle);
      context.roundRect(x - 4, y - 4, 8, 8, 2);
    }
    context.fill();
    context.stroke();
  }
  if (handles.includes("lift")) drawLift(context, frame, handlePlace(box, "lift"), box, lifted);
}

function drawTurn(context: CanvasRenderingContext2D, { x, y }: ScreenPoint, top: number): void {
  const stem = sharp(x);
  context.lineWidth = 1;
  context.beginPath();
  context.moveTo(stem, top);
  context.lineTo(stem, y + 4.5);
  context.stroke();
  context.lineWidth = 1.5;
  context.beginPath();
  context.arc(x, y, 4.5, 0, 2 * Math.PI);
  context.fill();
  context.stroke();
}

/** Half the width and height of the capsule. */
const CAPSULE = { x: 5, y: 9 } as const;

/** Held by the box's edge, or by a lone agent's ring, and by where it came from while it is pulled. */
function drawLift(
  context: CanvasRenderingContext2D,
  { palette, radius }: Frame,
  rest: ScreenPoint,
  box: SelectionBox,
  lifted: number,
): void {
  const [x, y] = [sharp(rest.x), sharp(rest.y)];
  const now = y - lifted;
  context.lineWidth = 1;
  context.beginPath();
  if (box.isSpot) context.moveTo(x, (box.top + box.bottom) / 2 - radius - 5);
  else context.moveTo(box.right + 4, y);
  context.lineTo(x, y);
  context.lineTo(x, now);
  context.stroke();
  context.lineWidth = 1.5;
  context.beginPath();
  context.roundRect(x - CAPSULE.x, now - CAPSULE.y, 2 * CAPSULE.x, 2 * CAPSULE.y, CAPSULE.x);
  context.fill();
  context.stroke();
  context.fillStyle = palette.you;
  context.beginPath();
  for (const up of [-1, 1]) {
    context.moveTo(x - 2.5, now + 1.5 * up);
    context.lineTo(x, now + 5 * up);
    context.lineTo(x + 2.5, now + 1.5 * up);
    context.closePath();
  }
  context.fill();
}

/** On a pixel's center. */
function sharp(value: number): number {
  return Math.round(value - 0.5) + 0.5;
}
