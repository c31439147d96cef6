import type { Stage } from "../../document/scene";
import type { Bounds } from "../camera";
import type { Frame } from "../frame";
import { drawFootball } from "./football";
import { drawSoccer } from "./soccer";
import { drawTheater } from "./theater";

/** What is painted on a stage beyond a grid. */
export function drawPainted(context: CanvasRenderingContext2D, frame: Frame, sheet: Bounds, stage: Stage): void {
  switch (stage.backdrop) {
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
    default:
  }
}
