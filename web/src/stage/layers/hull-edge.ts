import type { Frame } from "../frame";
import { fade } from "../spacing";
import { type HullShape, hullWidth, traceHull } from "./hulls";

/**
 * The edge of one hull, 1 px of its color at half strength.
 *
 * `scratch` has the stage's size and density; it is left transparent.
 */
export function drawHullEdge(
  context: CanvasRenderingContext2D,
  frame: Frame,
  shape: HullShape,
  scratch: CanvasRenderingContext2D,
): void {
  if (fade(frame.spacing, 11, 16) === 0) return;
  const half = hullWidth(frame) / 2;
  scratch.fillStyle = shape.color;
  traceHull(scratch, frame, shape, half + 0.5);
  scratch.fill();
  scratch.globalCompositeOperation = "destination-out";
  traceHull(scratch, frame, shape, half - 0.5);
  scratch.fill();
  scratch.globalCompositeOperation = "source-over";
  context.globalAlpha = 0.5;
  context.drawImage(scratch.canvas, 0, 0, frame.size.width, frame.size.height);
  context.globalAlpha = 1;
  scratch.clearRect(0, 0, frame.size.width, frame.size.height);
}
