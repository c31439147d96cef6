import type { Units } from "../../document/scene";
import { formatNumber, metersPer } from "../../document/units";
import type { Frame } from "../frame";
import { fade } from "../spacing";
import { font } from "./text";

/** Nobody sees less than this, meters. */
const ON_THE_GROUND = 0.005;

/** Above ground a disc wears a ring; how high it is stands at its foot where there is room. */
export function drawHeights(context: CanvasRenderingContext2D, frame: Frame, units: Units): void {
  const { heights, points, palette, radius } = frame;
  if (!heights) return;
  const alpha = fade(frame.spacing, 24, 30);
  context.strokeStyle = palette.ink;
  context.lineWidth = 1;
  context.font = font(palette, 9, 500);
  context.textAlign = "center";
  context.textBaseline = "middle";
  for (let agent = 0; agent < frame.agentCount; agent += 1) {
    const height = heights[agent] ?? 0;
    const x = points[2 * agent] ?? 0;
    const y = points[2 * agent + 1] ?? 0;
    if (Math.abs(height) < ON_THE_GROUND || !frame.sees(x, y, radius + 14)) continue;
    context.globalAlpha = 0.6;
    context.beginPath();
    context.arc(x, y, radius + 1.5, 0, 2 * Math.PI);
    context.stroke();
    if (alpha === 0) continue;
    context.globalAlpha = alpha;
    context.fillStyle = palette.ink2;
    context.fillText(short(height / metersPer(units)), x, y + radius + 8);
  }
  context.globalAlpha = 1;
}

/** As few figures as tell heights apart. */
function short(value: number): string {
  return formatNumber(value, Math.abs(value) < 9.95 ? 1 : 0);
}
