import type { Camera, Size } from "../../stage/camera";
import type { Palette } from "../../stage/palette";
import { discRadius, neighborSpacing, screenSpacing } from "../../stage/spacing";
import { trianglesOf } from "../../stage/ties";
import { coefficientsOf, cutLine, cutPairs, partialFormation, sidesOf } from "./mode-geometry";
import type { ModesPicture } from "./picture";

/** How much of the show behind still shows through. */
const VEIL = 0.93;

/** With many more ties an agent than the three of a triangulation, strokes through triangles are a tangle and no line. */
const FEW_TIES = 4;

/** Everything about one mode that a frame draws; made when the mode changes, not when the camera moves. */
export interface ModeSketch {
  readonly picture: ModesPicture;
  readonly sides: Int8Array;
  /** By agent, 0..1 of the greatest. */
  readonly strengths: Float64Array;
  readonly cut: Uint32Array;
  readonly line: Float64Array;
  /** The formation without and with this mode, x, y an agent in meters; without: empty for the first mode. */
  readonly before: Float64Array;
  readonly after: Float64Array;
}

export function sketchOf(picture: ModesPicture): ModeSketch {
  const { basis, formation, pairs, count } = picture;
  const mode = basis.mode(count - 1);
  const sides = sidesOf(mode);
  const coefficients = coefficientsOf(basis, formation);
  const greatest = mode.reduce((most, entry) => Math.max(most, Math.abs(entry)), 0);
  const isNearlyPlane = pairs.length / 2 <= FEW_TIES * basis.agentCount;
  return {
    picture,
    sides,
    strengths: mode.map((entry) => (greatest > 0 ? Math.abs(entry) / greatest : 0)),
    cut: cutPairs(pairs, sides),
    line: count > 1 && isNearlyPlane ? cutLine(mode, formation, trianglesOf(pairs)) : new Float64Array(0),
    before: count > 1 ? partialFormation(basis, coefficients, count - 1) : new Float64Array(0),
    after: partialFormation(basis, coefficients, count),
  };
}

/** Draws a mode: who is on which side, the ties it cuts, and what it adds to the modes before it. */
export function drawMode(
  context: CanvasRenderingContext2D,
  sketch: ModeSketch,
  { camera, size, palette, colors }: { camera: Camera; size: Size; palette: Palette; colors: readonly string[] },
): void {
  const { formation, pairs } = sketch.picture;
  const radius = discRadius(screenSpacing(neighborSpacing(formation), camera.scale));
  const to = (xy: Float64Array, agent: number): [number, number] => [
    (xy[2 * agent] ?? 0) * camera.scale + camera.left,
    camera.top - (xy[2 * agent + 1] ?? 0) * camera.scale,
  ];
  context.clearRect(0, 0, size.width, size.height);
  context.globalAlpha = VEIL;
  context.fillStyle = palette.sheet;
  context.fillRect(0, 0, size.width, size.height);
  context.lineCap = "round";
  context.strokeStyle = palette.tie;
  strokePairs(context, pairs, (agent) => to(formation.xy, agent), 0.8, 0.2);
  drawContributions(context, sketch, to, radius, palette);
  drawReconstruction(context, sketch, to, radius, colors);
  context.strokeStyle = palette.ink;
  strokePairs(context, sketch.cut, (agent) => to(formation.xy, agent), 1.6, 0.85);
  drawLine(context, sketch.line, camera, palette);
  drawSides(context, sketch, to, radius, palette);
  context.globalAlpha = 1;
}

type ToScreen = (xy: Float64Array, agent: number) => [x: number, y: number];

function strokePairs(
  context: CanvasRenderingContext2D,
  pairs: Uint32Array,
  place: (agent: number) => [number, number],
  width: number,
  alpha: number,
): void {
  context.globalAlpha = alpha;
  context.lineWidth = width;
  context.beginPath();
  for (let k = 0; k + 1 < pairs.length; k += 2) {
    context.moveTo(...place(pairs[k] ?? 0));
    context.lineTo(...place(pairs[k + 1] ?? 0));
  }
  context.stroke();
}

/** From thin to thick: where the modes before this one have an agent, and where this one takes it. */
function drawContributions(
  context: CanvasRenderingContext2D,
  { before, after }: ModeSketch,
  to: ToScreen,
  radius: number,
  palette: Palette,
): void {
  if (before.length === 0) return;
  const thick = Math.max(1, 0.6 * radius);
  context.globalAlpha = 0.42;
  context.fillStyle = palette.ink2;
  context.beginPath();
  for (let agent = 0; agent < after.length / 2; agent += 1) {
    const [ax, ay] = to(before, agent);
    const [bx, by] = to(after, agent);
    const length = Math.hypot(bx - ax, by - ay);
    if (length < 1) continue;
    const [nx, ny] = [(ay - by) / length, (bx - ax) / length];
    context.moveTo(ax + 0.3 * nx, ay + 0.3 * ny);
    context.lineTo(bx + thick * nx, by + thick * ny);
    context.lineTo(bx - thick * nx, by - thick * ny);
    context.lineTo(ax - 0.3 * nx, ay - 0.3 * ny);
    context.closePath();
  }
  context.fill();
}

function drawReconstruction(
  context: CanvasRenderingContext2D,
  { after }: ModeSketch,
  to: ToScreen,
  radius: number,
  colors: readonly string[],
): void {
  context.globalAlpha = 0.5;
  for (let agent = 0; agent < after.length / 2; agent += 1) {
    context.fillStyle = colors[agent] ?? "";
    context.beginPath();
    context.arc(...to(after, agent), 0.85 * radius, 0, 2 * Math.PI);
    context.fill();
  }
}

function drawLine(context: CanvasRenderingContext2D, line: Float64Array, camera: Camera, palette: Palette): void {
  context.globalAlpha = 1;
  context.strokeStyle = palette.ink;
  context.lineWidth = 1.25;
  context.setLineDash([6, 4]);
  context.beginPath();
  for (let k = 0; k + 3 < line.length; k += 4) {
    context.moveTo((line[k] ?? 0) * camera.scale + camera.left, camera.top - (line[k + 1] ?? 0) * camera.scale);
    context.lineTo((line[k + 2] ?? 0) * camera.scale + camera.left, camera.top - (line[k + 3] ?? 0) * camera.scale);
  }
  context.stroke();
  context.setLineDash([]);
}

/** Filled on one side, hollow on the other, the larger the more the mode moves an agent. */
function drawSides(
  context: CanvasRenderingContext2D,
  { picture, sides, strengths }: ModeSketch,
  to: ToScreen,
  radius: number,
  palette: Palette,
): void {
  context.globalAlpha = 1;
  context.lineWidth = Math.max(1, 0.16 * radius);
  context.strokeStyle = palette.ink;
  for (let agent = 0; agent < picture.formation.agentCount; agent += 1) {
    context.fillStyle = (sides[agent] ?? 0) > 0 ? palette.ink : palette.sheet;
    context.beginPath();
    context.arc(...to(picture.formation.xy, agent), radius * (0.4 + 0.6 * (strengths[agent] ?? 0)), 0, 2 * Math.PI);
    context.fill();
    context.stroke();
  }
}
