import { nearestOn } from "../../document/obstacle";
import type { AdjacencySpec, Obstacle, ObstacleShape } from "../../document/scene";
import type { Frame } from "../frame";

/** What an outline is drawn by. */
export type OutlineFrame = Pick<Frame, "camera" | "size" | "palette" | "screenX" | "screenY">;

const HATCH_STEP = 6;
const HATCH_ALPHA = 0.22;

/** What agents go around, hatched as on a plan; the selected one's edge is the person's. */
export function drawObstacles(
  context: CanvasRenderingContext2D,
  frame: OutlineFrame,
  obstacles: readonly Obstacle[],
  selected: number | null,
): void {
  obstacles.forEach(({ shape }, index) => {
    context.save();
    context.beginPath();
    traceShape(context, frame, shape);
    context.fillStyle = frame.palette.sheet;
    context.fill();
    context.clip();
    hatch(context, frame, shape);
    context.restore();
    context.beginPath();
    traceShape(context, frame, shape);
    context.lineWidth = index === selected ? 2 : 1.25;
    context.strokeStyle = index === selected ? frame.palette.you : frame.palette.ink3;
    context.stroke();
  });
}

/** Who is tied to an obstacle, by a line to the nearest place of its outline. */
export function drawObstacleTies(
  context: CanvasRenderingContext2D,
  frame: Frame,
  obstacles: readonly Obstacle[],
  ties: AdjacencySpec["obstacleTies"],
): void {
  context.lineWidth = 1;
  context.strokeStyle = frame.palette.tie;
  context.globalAlpha = 0.5;
  context.beginPath();
  for (const [agent, index] of ties) {
    const shape = obstacles[index]?.shape;
    const [x, y] = [frame.places[2 * agent], frame.places[2 * agent + 1]];
    if (!shape || x === undefined || y === undefined) continue;
    const [toX, toY] = nearestOn(shape, [x, y]);
    context.moveTo(frame.screenX(x), frame.screenY(y));
    context.lineTo(frame.screenX(toX), frame.screenY(toY));
  }
  context.stroke();
  context.globalAlpha = 1;
}

/** Adds an outline to the path. */
export function traceShape(context: CanvasRenderingContext2D, frame: OutlineFrame, shape: ObstacleShape): void {
  if (shape.kind === "circle") {
    const [x, y] = shape.center;
    context.arc(frame.screenX(x), frame.screenY(y), shape.radius * frame.camera.scale, 0, 2 * Math.PI);
    return;
  }
  shape.points.forEach(([x, y], index) => {
    if (index === 0) context.moveTo(frame.screenX(x), frame.screenY(y));
    else context.lineTo(frame.screenX(x), frame.screenY(y));
  });
  context.closePath();
}

/** Lines that rise to the right, over as much of the shape as can be seen. */
function hatch(context: CanvasRenderingContext2D, frame: OutlineFrame, shape: ObstacleShape): void {
  const { camera, size, palette } = frame;
  const points = shape.kind === "circle" ? corners(shape.center, shape.radius) : shape.points;
  const xs = points.map(([x]) => frame.screenX(x));
  const ys = points.map(([, y]) => frame.screenY(y));
  const left = Math.max(0, Math.min(...xs));
  const right = Math.min(size.width, Math.max(...xs));
  const top = Math.max(0, Math.min(...ys));
  const bottom = Math.min(size.height, Math.max(...ys));
  if (right <= left || bottom <= top) return;
  // Fixed to the stage: hatching that swims while somebody pans reads as motion.
  const origin = camera.left + camera.top;
  const first = Math.floor((left + top - origin) / HATCH_STEP) * HATCH_STEP + origin;
  context.globalAlpha = HATCH_ALPHA;
  context.lineWidth = 1;
  context.strokeStyle = palette.tie;
  context.beginPath();
  for (let sum = first; sum < right + bottom; sum += HATCH_STEP) {
    context.moveTo(sum - bottom, bottom);
    context.lineTo(sum - top, top);
  }
  context.stroke();
  context.globalAlpha = 1;
}

function corners([x, y]: readonly [number, number], reach: number): readonly (readonly [number, number])[] {
  return [
    [x - reach, y - reach],
    [x + reach, y + reach],
  ];
}
