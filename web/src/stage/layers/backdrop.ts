import type { Stage } from "../../document/scene";
import type { Frame } from "../frame";
import { sheetOf } from "../sheet";
import { crisp } from "./crisp";
import { drawFootball } from "./football";
import { drawAxisNumbers, drawGrid } from "./grid";
import { drawSoccer } from "./soccer";
import { drawTheater } from "./theater";

const CORNER = 3;

/** Everything the agents stand on, edge to edge of the canvas. */
export function drawBackdrop(context: CanvasRenderingContext2D, frame: Frame, stage: Stage): void {
  const { palette, size } = frame;
  const sheet = sheetOf(stage);
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
  switch (stage.backdrop) {
    case "grid":
      drawGrid(context, frame, sheet, stage.units);
      break;
    case "football-college":
      drawFootball(context, frame, sheet, "college");
      break;
    case "football-hs":
      drawFootball(context, frame, sheet, "high-school");
      break;
    case "soccer":
      drawSoccer(context, frame);
      break;
    case "stage":
      drawTheater(context, frame, sheet);
      break;
    case "none":
      break;
  }
  context.restore();

  if (stage.backdrop === "grid") drawAxisNumbers(context, frame, sheet, stage.units);
  context.lineWidth = 1;
  context.strokeStyle = palette.fieldLine;
  context.beginPath();
  const [edgeX, edgeY] = [crisp(left), crisp(top)];
  context.roundRect(edgeX, edgeY, crisp(left + width) - 1 - edgeX, crisp(top + height) - 1 - edgeY, CORNER);
  context.stroke();
}
