import type { Overlay } from "../../tools/toolbox";
import type { Frame } from "../frame";
import { crisp } from "./crisp";
import { traceShape } from "./obstacles";
import { drawReadout } from "./readout";
import { drawPlaces, drawStroke } from "./stroke";

/** How far a readout stands above the pointer, CSS pixels. */
const ABOVE_POINTER = 30;

/** What the tool at work shows. */
export function drawOverlay(context: CanvasRenderingContext2D, frame: Frame, overlay: Overlay): void {
  switch (overlay.kind) {
    case "none":
    // With the box whose handle it is.
    case "lift":
      break;
    case "marquee":
      drawMarquee(context, frame, overlay);
      break;
    case "stroke":
      drawStroke(context, frame, overlay.stroke, overlay.isClosed);
      drawPlaces(context, frame, overlay.places);
      break;
    case "shape":
      drawStroke(context, frame, overlay.outline, false);
      drawPlaces(context, frame, overlay.places);
      break;
    case "outline":
      drawOutline(context, frame, overlay);
      break;
    case "tie":
      drawTiePreview(context, frame, overlay);
      break;
    case "guides":
      drawGuides(context, frame, overlay);
      break;
  }
}

function drawMarquee(context: CanvasRenderingContext2D, frame: Frame, overlay: Overlay & { kind: "marquee" }): void {
  const left = crisp(frame.screenX(Math.min(overlay.from[0], overlay.to[0])));
  const right = crisp(frame.screenX(Math.max(overlay.from[0], overlay.to[0])));
  const top = crisp(frame.screenY(Math.max(overlay.from[1], overlay.to[1])));
  const bottom = crisp(frame.screenY(Math.min(overlay.from[1], overlay.to[1])));
  context.globalAlpha = 0.08;
  context.fillStyle = frame.palette.you;
  context.fillRect(left, top, right - left, bottom - top);
  context.globalAlpha = 1;
  context.lineWidth = 1;
  context.strokeStyle = frame.palette.you;
  context.strokeRect(left, top, right - left, bottom - top);
}

/** An obstacle being made: its edge, and the way to the next corner. */
function drawOutline(context: CanvasRenderingContext2D, frame: Frame, overlay: Overlay & { kind: "outline" }): void {
  const { shape, next } = overlay;
  context.lineWidth = 1.5;
  context.strokeStyle = frame.palette.you;
  context.beginPath();
  if (shape.kind === "circle") traceShape(context, frame, shape);
  else {
    for (const [x, y] of shape.points) context.lineTo(frame.screenX(x), frame.screenY(y));
    if (next) context.lineTo(frame.screenX(next[0]), frame.screenY(next[1]));
  }
  context.stroke();
  context.fillStyle = frame.palette.sheet;
  context.beginPath();
  for (const [x, y] of shape.kind === "circle" ? [] : shape.points) {
    context.roundRect(frame.screenX(x) - 4, frame.screenY(y) - 4, 8, 8, 2);
  }
  context.fill();
  context.stroke();
}

/** A tie being drawn; firm once it has reached an agent. */
function drawTiePreview(context: CanvasRenderingContext2D, frame: Frame, overlay: Overlay & { kind: "tie" }): void {
  const { points, palette, radius } = frame;
  const { from, to, target } = overlay;
  const x = points[2 * from] ?? 0;
  const y = points[2 * from + 1] ?? 0;
  const endX = target === null ? frame.screenX(to[0]) : (points[2 * target] ?? 0);
  const endY = target === null ? frame.screenY(to[1]) : (points[2 * target + 1] ?? 0);
  context.lineWidth = 2;
  context.lineCap = "round";
  context.strokeStyle = palette.you;
  if (target === null) context.setLineDash([4, 5]);
  context.beginPath();
  context.moveTo(x, y);
  context.lineTo(endX, endY);
  context.stroke();
  context.setLineDash([]);
  context.beginPath();
  for (const [cx, cy] of target === null ? [[x, y] as const] : [[x, y] as const, [endX, endY] as const]) {
    context.moveTo(cx + radius + 3, cy);
    context.arc(cx, cy, radius + 3, 0, 2 * Math.PI);
  }
  context.stroke();
}

function drawGuides(context: CanvasRenderingContext2D, frame: Frame, overlay: Overlay & { kind: "guides" }): void {
  const { palette } = frame;
  for (const { from, to, gap } of overlay.lines) {
    const fromX = frame.screenX(from[0]);
    const fromY = frame.screenY(from[1]);
    const toX = frame.screenX(to[0]);
    const toY = frame.screenY(to[1]);
    context.lineWidth = 1;
    context.strokeStyle = palette.you;
    context.beginPath();
    // Upright and level guides are sharp.
    context.moveTo(fromX === toX ? crisp(fromX) : fromX, fromY === toY ? crisp(fromY) : fromY);
    context.lineTo(fromX === toX ? crisp(toX) : toX, fromY === toY ? crisp(toY) : toY);
    context.stroke();
    if (gap !== null) drawReadout(context, frame, gap, (fromX + toX) / 2, (fromY + toY) / 2);
  }
  if (overlay.height) {
    const { at, words } = overlay.height;
    drawReadout(context, frame, words, frame.screenX(at[0]), frame.screenY(at[1]) - ABOVE_POINTER);
  }
}
