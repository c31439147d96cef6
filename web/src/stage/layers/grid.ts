import type { Units } from "../../document/scene";
import { formatNumber, metersPer } from "../../document/units";
import type { Bounds } from "../camera";
import type { Frame } from "../frame";
import { fade } from "../spacing";
import { crisp } from "./crisp";
import { font } from "./text";

/** Lines of the grid: every `major` meters, and `parts` fainter ones to each. */
export interface GridSteps {
  readonly major: number;
  readonly parts: number;
}

/** Lines are at least this far apart, CSS pixels: room for their numbers. */
const ROOM = 42;

/** How far apart lines are at a scale of pixels a meter: round figures of the scene's units, fives by default. */
export function gridSteps(scale: number, units: Units): GridSteps {
  const unit = metersPer(units);
  const [first, parts] = units === "steps" ? [4, 4] : [1, 5];
  let count = first;
  let isFive = false;
  while (count * unit * scale < ROOM) {
    // 1, 5, 10, 50 … of most units; 4, 8, 16 … steps.
    count *= units === "steps" ? 2 : isFive ? 2 : 5;
    isFive = !isFive;
  }
  return { major: count * unit, parts };
}

/** The sheet with its lines; the fainter ones appear as they get room. */
export function drawGrid(context: CanvasRenderingContext2D, frame: Frame, sheet: Bounds, units: Units): void {
  const { palette, camera } = frame;
  const { major, parts } = gridSteps(camera.scale, units);
  const minor = major / parts;
  context.lineWidth = 1;
  const fifths = fade(minor * camera.scale, 9, 13);
  if (fifths > 0) {
    context.strokeStyle = palette.fieldLineMinor;
    context.globalAlpha = fifths;
    strokeLines(context, frame, sheet, minor);
  }
  context.strokeStyle = palette.fieldLine;
  context.globalAlpha = 0.75;
  strokeLines(context, frame, sheet, major);
  context.globalAlpha = 1;
}

/** Numbers of the grid's lines beside the sheet, the unit after the last. */
export function drawAxisNumbers(context: CanvasRenderingContext2D, frame: Frame, sheet: Bounds, units: Units): void {
  const { major } = gridSteps(frame.camera.scale, units);
  const unit = metersPer(units);
  const decimals = major / unit < 1 ? 1 : 0;
  const label = (meters: number) => formatNumber(meters / unit, decimals);
  context.fillStyle = frame.palette.ink3;
  context.font = font(frame.palette, 10, 400);
  context.textAlign = "center";
  context.textBaseline = "top";
  const front = frame.screenY(sheet.minY) + 7;
  const lastX = Math.floor(sheet.maxX / major + 1e-9) * major;
  for (let x = firstLine(sheet.minX, major); x <= lastX + 1e-9; x += major) {
    const isLast = x > lastX - major / 2;
    context.fillText(isLast ? `${label(x)} ${units}` : label(x), frame.screenX(x), front);
  }
  context.textAlign = "right";
  context.textBaseline = "middle";
  const left = frame.screenX(sheet.minX) - 8;
  for (let y = firstLine(sheet.minY, major); y <= sheet.maxY + 1e-9; y += major) {
    context.fillText(label(y), left, frame.screenY(y));
  }
}

function strokeLines(context: CanvasRenderingContext2D, frame: Frame, sheet: Bounds, step: number): void {
  const { camera, size } = frame;
  const left = Math.max(frame.screenX(sheet.minX), 0);
  const right = Math.min(frame.screenX(sheet.maxX), size.width);
  const back = Math.max(frame.screenY(sheet.maxY), 0);
  const front = Math.min(frame.screenY(sheet.minY), size.height);
  const minX = Math.max(sheet.minX, -camera.left / camera.scale);
  const maxX = Math.min(sheet.maxX, (size.width - camera.left) / camera.scale);
  const minY = Math.max(sheet.minY, (camera.top - size.height) / camera.scale);
  const maxY = Math.min(sheet.maxY, camera.top / camera.scale);
  context.beginPath();
  for (let x = firstLine(minX, step); x <= maxX; x += step) {
    const at = crisp(frame.screenX(x));
    context.moveTo(at, back);
    context.lineTo(at, front);
  }
  for (let y = firstLine(minY, step); y <= maxY; y += step) {
    const at = crisp(frame.screenY(y));
    context.moveTo(left, at);
    context.lineTo(right, at);
  }
  context.stroke();
}

function firstLine(from: number, step: number): number {
  return Math.ceil(from / step - 1e-9) * step;
}
