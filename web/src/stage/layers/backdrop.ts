import type { Stage } from "../../document/scene";
import { type Bounds, toStage } from "../camera";
import type { Frame } from "../frame";
import { later } from "../later";
import { sheetOf } from "../sheet";
import { crisp } from "./crisp";
import { drawAxisNumbers, drawGrid } from "./grid";

const painted = later(() => import("./painted"));

const CORNER = 3;

/** On a stage this narrow a plain sheet runs on beyond its edge: there is no room for what lies around it. */
const NARROW = 640;

/** Everything the agents stand on, edge to edge of the canvas. */
export function drawBackdrop(context: CanvasRenderingContext2D, frame: Frame, stage: Stage): void {
  const { palette, size } = frame;
  const bleeds = size.width <= NARROW && (stage.backdrop === "grid" || stage.backdrop === "none");
  const sheet = bleeds ? visibleBounds(frame) : sheetOf(stage);
  const left = frame.screenX(sheet.minX);
  const top = frame.screenY(sheet.maxY);
  const width = frame.screenX(sheet.maxX) - left;
  const height = frame.screenY(sheet.minY) - top;
  context.fillStyle = palette.ground;
  context.fillRect(0, 0, size.width, size.height);
  context.fillStyle = palette.sheet;
  context.beginPath();
  context.roundRect(left, top, width, height, CORNER);
  context.fill();

  context.save();
  if (stage.backdrop !== "stage") context.clip();
  if (stage.backdrop === "grid") drawGrid(context, frame, sheet, stage.units);
  else if (stage.backdrop !== "none") painted()?.drawPainted(context, frame, sheet, stage);
  context.restore();

  if (stage.backdrop === "grid" && !bleeds) drawAxisNumbers(context, frame, sheet, stage.units);
  drawEdge(context, frame, sheetOf(stage), bleeds ? 0 : 1);
}

/** The edge, `inset` pixels inside at the right and in front: on the sheet's last pixel, or on the grid's line. */
function drawEdge(context: CanvasRenderingContext2D, frame: Frame, sheet: Bounds, inset: number): void {
  const left = crisp(frame.screenX(sheet.minX));
  const top = crisp(frame.screenY(sheet.maxY));
  context.lineWidth = 1;
  context.strokeStyle = frame.palette.fieldLine;
  context.beginPath();
  const right = crisp(frame.screenX(sheet.maxX)) - inset;
  const bottom = crisp(frame.screenY(sheet.minY)) - inset;
  context.roundRect(left, top, right - left, bottom - top, CORNER);
  context.stroke();
}

/** A little more than what the canvas shows. */
function visibleBounds({ camera, size }: Frame): Bounds {
  const [left, top] = toStage(camera, { x: -8, y: -8 });
  const [right, bottom] = toStage(camera, { x: size.width + 8, y: size.height + 8 });
  return { minX: left, maxX: right, minY: bottom, maxY: top };
}
