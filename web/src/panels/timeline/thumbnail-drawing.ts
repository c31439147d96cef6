import type { Formation } from "../../document/formation";
import type { Palette } from "../../stage/palette";
import { clamp, neighborSpacing } from "../../stage/spacing";

const PADDING = 7;

/** Draws a formation to fill a canvas of width × height CSS pixels; `colors` are stored colors by agent. */
export function drawFormation(
  canvas: HTMLCanvasElement,
  size: { readonly width: number; readonly height: number },
  formation: Formation,
  colors: readonly string[],
  palette: Palette,
): void {
  const context = canvas.getContext("2d");
  if (!context) return;
  const density = globalThis.devicePixelRatio || 1;
  canvas.width = Math.round(size.width * density);
  canvas.height = Math.round(size.height * density);
  if (formation.agentCount === 0) return;
  const points = formation.points();
  const xs = points.map(([x]) => x);
  const ys = points.map(([, y]) => y);
  const [left, right] = [Math.min(...xs), Math.max(...xs)];
  const [bottom, top] = [Math.min(...ys), Math.max(...ys)];
  const scale = Math.min(
    (size.width - 2 * PADDING) / Math.max(right - left, 1),
    (size.height - 2 * PADDING) / Math.max(top - bottom, 1),
  );
  const radius = clamp(0.34 * neighborSpacing(formation) * scale, 0.9, 2.6);
  context.scale(density, density);
  for (const [agent, [x, y]] of points.entries()) {
    context.fillStyle = palette.shown(colors[agent] ?? "");
    context.beginPath();
    context.arc(
      size.width / 2 + (x - (left + right) / 2) * scale,
      size.height / 2 - (y - (bottom + top) / 2) * scale,
      radius,
      0,
      2 * Math.PI,
    );
    context.fill();
  }
}
