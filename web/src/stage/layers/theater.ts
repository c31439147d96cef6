import type { Bounds } from "../camera";
import type { Frame } from "../frame";
import { crisp } from "./crisp";
import { font } from "./text";

/** A theater stage seen from above: its center and quarter lines, and the edge where the audience sits. */
export function drawTheater(context: CanvasRenderingContext2D, frame: Frame, sheet: Bounds): void {
  const { palette } = frame;
  const left = frame.screenX(sheet.minX);
  const right = frame.screenX(sheet.maxX);
  const back = frame.screenY(sheet.maxY);
  const front = frame.screenY(sheet.minY);
  const width = right - left;
  const depth = front - back;
  context.lineWidth = 1;
  context.strokeStyle = palette.fieldLineMinor;
  context.beginPath();
  for (let eighth = 1; eighth < 8; eighth += 2) {
    const x = crisp(left + (width * eighth) / 8);
    context.moveTo(x, back);
    context.lineTo(x, front);
  }
  context.stroke();
  context.strokeStyle = palette.fieldLine;
  context.beginPath();
  for (const x of [1 / 4, 1 / 2, 3 / 4]) {
    context.moveTo(crisp(left + width * x), back);
    context.lineTo(crisp(left + width * x), front);
  }
  for (const y of [1 / 3, 2 / 3]) {
    context.moveTo(left, crisp(back + depth * y));
    context.lineTo(right, crisp(back + depth * y));
  }
  context.stroke();
  drawApron(context, frame, left, right, front);
}

/** The bulge toward the audience, and where that is. */
function drawApron(context: CanvasRenderingContext2D, frame: Frame, left: number, right: number, front: number): void {
  const { palette } = frame;
  const bulge = Math.min((right - left) * 0.05, 28);
  context.beginPath();
  context.moveTo(left, front);
  context.quadraticCurveTo((left + right) / 2, front + 2 * bulge, right, front);
  context.fillStyle = palette.sheet;
  context.fill();
  context.strokeStyle = palette.fieldLine;
  context.stroke();
  context.fillStyle = palette.ink3;
  context.font = font(palette, 10, 400);
  context.textAlign = "center";
  context.textBaseline = "top";
  context.fillText("Audience", (left + right) / 2, front + bulge + 8);
}
