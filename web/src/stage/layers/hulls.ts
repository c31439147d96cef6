import type { Frame } from "../frame";
import { clamp, fade, smoothstep } from "../spacing";

/** A group's agents and the ties among them, over which its hull reaches. */
export interface HullShape {
  readonly color: string;
  readonly agents: Uint32Array;
  /** a0, b0, a1, b1, … */
  readonly pairs: Uint32Array;
  /** a0, b0, c0, … of agents all tied to each other; filled where bands leave a gap. */
  readonly triangles: Uint32Array;
}

/** Ties up to so many spacings long are covered; the cover retracts from there on, so that a hull never pops. */
const COVERED = { from: 2.6, to: 3.2 } as const;

const CORNERS = 24;
const COSINES = Float64Array.from({ length: CORNERS }, (_, corner) => Math.cos((2 * Math.PI * corner) / CORNERS));
const SINES = Float64Array.from({ length: CORNERS }, (_, corner) => Math.sin((2 * Math.PI * corner) / CORNERS));

/** Soft areas behind the groups: one path each, so that a hull has one tone however its parts overlap. */
export function drawHulls(context: CanvasRenderingContext2D, frame: Frame, shapes: readonly HullShape[]): void {
  const alpha = frame.palette.hullAlpha * fade(frame.spacing, 11, 16);
  if (alpha < 0.004) return;
  const half = hullWidth(frame) / 2;
  context.globalAlpha = alpha;
  for (let k = 0; k < shapes.length; k += 1) {
    const shape = shapes[k];
    if (!shape) continue;
    context.fillStyle = shape.color;
    traceHull(context, frame, shape, half);
    context.fill();
  }
  context.globalAlpha = 1;
}

/** How wide a hull is about each of its agents, CSS pixels. */
export function hullWidth(frame: Frame): number {
  return Math.min(2.3 * clamp(frame.spacing, 9, 400), 84);
}

/** Triangles between covered sides, turned like everything else in the path; they shrink away as a side gets too long. */
function traceInside(context: CanvasRenderingContext2D, { points, spacing }: Frame, triangles: Uint32Array): void {
  for (let k = 0; k + 2 < triangles.length; k += 3) {
    const a = 2 * (triangles[k] ?? 0);
    const b = 2 * (triangles[k + 1] ?? 0);
    const c = 2 * (triangles[k + 2] ?? 0);
    const ax = points[a] ?? 0;
    const ay = points[a + 1] ?? 0;
    const bx = (points[b] ?? 0) - ax;
    const by = (points[b + 1] ?? 0) - ay;
    const cx = (points[c] ?? 0) - ax;
    const cy = (points[c + 1] ?? 0) - ay;
    const longest = Math.max(bx * bx + by * by, cx * cx + cy * cy, (bx - cx) ** 2 + (by - cy) ** 2);
    // Half covered sides still meet in the middle: until then the triangle stays whole.
    const cover = Math.min(2 * coverOf(Math.sqrt(longest) / spacing), 1);
    if (cover === 0) continue;
    const middleX = ax + (bx + cx) / 3;
    const middleY = ay + (by + cy) / 3;
    const toX = (x: number) => middleX + (x - middleX) * cover;
    const toY = (y: number) => middleY + (y - middleY) * cover;
    const isClockwise = bx * cy - by * cx > 0;
    context.moveTo(toX(ax), toY(ay));
    context.lineTo(toX(ax + (isClockwise ? bx : cx)), toY(ay + (isClockwise ? by : cy)));
    context.lineTo(toX(ax + (isClockwise ? cx : bx)), toY(ay + (isClockwise ? cy : by)));
  }
}

/** How much of a tie is covered: all of a short one, nothing of a long one. */
export function coverOf(spacings: number): number {
  return 1 - smoothstep(COVERED.from, COVERED.to, spacings);
}

/** Discs of radius `half` about the agents, and bands as wide along the short ties; all wound alike, so none cancels another. */
export function traceHull(context: CanvasRenderingContext2D, frame: Frame, shape: HullShape, half: number): void {
  const { points, spacing } = frame;
  context.beginPath();
  // The bands cover any triangle until their width reaches its limit.
  if (half < 1.1 * spacing) traceInside(context, frame, shape.triangles);
  for (let k = 0; k < shape.agents.length; k += 1) {
    const agent = shape.agents[k] ?? 0;
    const x = points[2 * agent] ?? 0;
    const y = points[2 * agent + 1] ?? 0;
    if (frame.isGone?.[agent] || !frame.sees(x, y, half)) continue;
    traceDisc(context, x, y, half);
  }
  for (let k = 0; k + 1 < shape.pairs.length; k += 2) {
    const a = 2 * (shape.pairs[k] ?? 0);
    const b = 2 * (shape.pairs[k + 1] ?? 0);
    const ax = points[a] ?? 0;
    const ay = points[a + 1] ?? 0;
    const dx = (points[b] ?? 0) - ax;
    const dy = (points[b + 1] ?? 0) - ay;
    const length = Math.sqrt(dx * dx + dy * dy);
    const cover = coverOf(length / spacing);
    if (length === 0 || cover === 0 || !frame.sees(ax + dx / 2, ay + dy / 2, half + length)) continue;
    const nx = (-dy / length) * half;
    const ny = (dx / length) * half;
    if (cover === 1) {
      band(context, ax, ay, dx, dy, nx, ny);
    } else {
      const reach = cover / 2;
      stub(context, ax, ay, dx * reach, dy * reach, nx, ny, half);
      stub(context, ax + dx, ay + dy, -dx * reach, -dy * reach, -nx, -ny, half);
    }
  }
}

function band(
  context: CanvasRenderingContext2D,
  x: number,
  y: number,
  dx: number,
  dy: number,
  nx: number,
  ny: number,
): void {
  context.moveTo(x - nx, y - ny);
  context.lineTo(x + dx - nx, y + dy - ny);
  context.lineTo(x + dx + nx, y + dy + ny);
  context.lineTo(x + nx, y + ny);
}

/** A band with a round end where it stops short. */
function stub(
  context: CanvasRenderingContext2D,
  x: number,
  y: number,
  dx: number,
  dy: number,
  nx: number,
  ny: number,
  half: number,
): void {
  band(context, x, y, dx, dy, nx, ny);
  traceDisc(context, x + dx, y + dy, half);
}

/** A circle to within 0.4 px at the widest: hundreds of true ones, of a hundred edges each, would cost the frame. */
function traceDisc(context: CanvasRenderingContext2D, x: number, y: number, half: number): void {
  for (let corner = 0; corner < CORNERS; corner += 1) {
    const px = x + (COSINES[corner] ?? 0) * half;
    const py = y + (SINES[corner] ?? 0) * half;
    if (corner === 0) context.moveTo(px, py);
    else context.lineTo(px, py);
  }
}
