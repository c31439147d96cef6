import type { Frame } from "../frame";
import { SOCCER } from "../sheet";

/** Laws of the Game, meters. */
const CIRCLE = 9.15;
const PENALTY = { depth: 16.5, width: 40.32, spot: 11 } as const;
const GOAL_AREA = { depth: 5.5, width: 18.32 } as const;
const CORNER = 1;

/** A soccer pitch, the goals at the left and right. */
export function drawSoccer(context: CanvasRenderingContext2D, frame: Frame): void {
  const { palette, camera } = frame;
  const end = SOCCER.length / 2;
  const side = SOCCER.depth / 2;
  const x = (meters: number) => frame.screenX(meters);
  const y = (meters: number) => frame.screenY(meters);
  context.lineWidth = 1;
  context.strokeStyle = palette.fieldLine;
  context.beginPath();
  context.moveTo(x(0), y(side));
  context.lineTo(x(0), y(-side));
  circle(context, x(0), y(0), CIRCLE * camera.scale);
  for (const half of [-1, 1]) {
    for (const { depth, width } of [PENALTY, GOAL_AREA]) {
      const inner = x(half * (end - depth));
      context.moveTo(x(half * end), y(width / 2));
      context.lineTo(inner, y(width / 2));
      context.lineTo(inner, y(-width / 2));
      context.lineTo(x(half * end), y(-width / 2));
    }
    // The arc keeps the same distance from the spot, outside the penalty area only.
    const reach = Math.acos((PENALTY.depth - PENALTY.spot) / CIRCLE);
    const toward = half > 0 ? Math.PI : 0;
    const spot = x(half * (end - PENALTY.spot));
    context.moveTo(
      spot + Math.cos(toward - reach) * CIRCLE * camera.scale,
      y(0) + Math.sin(toward - reach) * CIRCLE * camera.scale,
    );
    context.arc(spot, y(0), CIRCLE * camera.scale, toward - reach, toward + reach);
    for (const flank of [-1, 1]) {
      const inward = Math.atan2(flank, -half);
      const cornerX = x(half * end);
      const cornerY = y(flank * side);
      const radius = CORNER * camera.scale;
      const start = inward - Math.PI / 4;
      context.moveTo(cornerX + Math.cos(start) * radius, cornerY + Math.sin(start) * radius);
      context.arc(cornerX, cornerY, radius, start, start + Math.PI / 2);
    }
  }
  context.stroke();
  context.fillStyle = palette.fieldLine;
  context.beginPath();
  for (const spot of [0, end - PENALTY.spot, PENALTY.spot - end]) circle(context, x(spot), y(0), 1.75);
  context.fill();
}

function circle(context: CanvasRenderingContext2D, x: number, y: number, radius: number): void {
  context.moveTo(x + radius, y);
  context.arc(x, y, radius, 0, 2 * Math.PI);
}
