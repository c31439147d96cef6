import type { Keyframe } from "../../document/scene";
import type { Palette } from "../../stage/palette";
import { clamp, neighborSpacing } from "../../stage/spacing";

const PADDING = 7;
const SMALLEST_DISC = 0.9;
const LARGEST_DISC = 2.6;

/** Draws who is there to fill a canvas of width × height CSS pixels; `colors` are stored colors by agent. */
export function drawFormation(
  canvas: HTMLCanvasElement,
  size: { readonly width: number; readonly height: number },
  { positions: formation, absent }: Pick<Keyframe, "positions" | "absent">,
  colors: readonly string[],
  palette: Palette,
): void {
  const context = canvas.getContext("2d");
  if (!context) return;
  const density = globalThis.devicePixelRatio || 1;
  canvas.width = Math.round(size.width * density);
  canvas.height = Math.round(size.height * density);
  if (formation.agentCount === 0) return;
  const [left, bottom, right, top] = boundsOf(formation.xy);
  const scale = Math.min(
    (size.width - 2 * PADDING) / Math.max(right - left, 1),
    (size.height - 2 * PADDING) / Math.max(top - bottom, 1),
  );
  const radius = clamp(0.34 * neighborSpacing(formation) * scale, SMALLEST_DISC, LARGEST_DISC);
  context.setTransform(density, 0, 0, density, 0, 0);
  context.translate(size.width / 2, size.height / 2);
  // One path a color: a hundred thumbnails of a thousand agents are drawn while somebody scrolls.
  const paths = new Map<string, Path2D>();
  const isAbsent = new Set(absent);
  for (let agent = 0; agent < formation.agentCount; agent += 1) {
    if (isAbsent.has(agent)) continue;
    const x = (formation.x(agent) - (left + right) / 2) * scale;
    const y = ((bottom + top) / 2 - formation.y(agent)) * scale;
    const color = colors[agent] ?? "";
    const path = paths.get(color) ?? new Path2D();
    paths.set(color, path);
    path.moveTo(x + radius, y);
    path.arc(x, y, radius, 0, 2 * Math.PI);
  }
  for (const [color, path] of paths) {
    context.fillStyle = palette.shown(color);
    context.fill(path);
  }
}

function boundsOf(xy: Float64Array): [left: number, bottom: number, right: number, top: number] {
  let [left, bottom, right, top] = [Infinity, Infinity, -Infinity, -Infinity];
  for (let index = 0; index < xy.length; index += 2) {
    const [x, y] = [xy[index] ?? 0, xy[index + 1] ?? 0];
    left = Math.min(left, x);
    right = Math.max(right, x);
    bottom = Math.min(bottom, y);
    top = Math.max(top, y);
  }
  return [left, bottom, right, top];
}
