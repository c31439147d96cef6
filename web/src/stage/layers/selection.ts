import type { Frame } from "../frame";
import { handlePlace, SCALE_HANDLES, type SelectionBox } from "../handles";

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

/** The box about a selection with its handles to scale and to turn. */
export function drawBox(context: CanvasRenderingContext2D, frame: Frame, box: SelectionBox): void {
  const { palette } = frame;
  context.lineWidth = 1;
  context.strokeStyle = palette.you;
  context.strokeRect(box.left, box.top, box.right - box.left, box.bottom - box.top);
  const turn = handlePlace(box, "rotate");
  const stem = Math.round(turn.x) + 0.5;
  context.beginPath();
  context.moveTo(stem, box.top);
  context.lineTo(stem, turn.y + 4.5);
  context.stroke();
  context.fillStyle = palette.sheet;
  context.lineWidth = 1.5;
  context.beginPath();
  for (const handle of SCALE_HANDLES) {
    const { x, y } = handlePlace(box, handle);
    context.roundRect(x - 4, y - 4, 8, 8, 2);
  }
  context.moveTo(turn.x + 4.5, turn.y);
  context.arc(turn.x, turn.y, 4.5, 0, 2 * Math.PI);
  context.fill();
  context.stroke();
}
