import type { Point } from "../../document/formation";
import { UNGROUPED_COLOR } from "../../document/palette";
import type { Frame } from "../frame";
import { outlineInto, trailLook } from "../ribbon";
import { clamp } from "../spacing";
import { haloWidth } from "./agents";

/** Agents about to be made have discs of this radius at most, CSS pixels. */
const LARGEST = 8;

/** Pieces of a step of the stroke, which may wind more than any path. */
const BENDS = 8;

/** A line being drawn: a trail of its own, faint where it began and firm where the pen is. */
export function drawStroke(
  context: CanvasRenderingContext2D,
  frame: Frame,
  stroke: readonly Point[],
  isClosed: boolean,
): void {
  if (stroke.length < 2) return;
  const color = frame.palette.shown(UNGROUPED_COLOR);
  const look = trailLook(30, LARGEST, frame.palette.trailAlpha, 1);
  const line = evenly(frame, stroke, look.steps * BENDS);
  const places = line.length / 2;
  const outline = new Float32Array(4 * places);
  outlineInto(line, places, look.tailWidth, look.headWidth * 0.8, outline, 0);
  context.fillStyle = color;
  if (isClosed) {
    context.globalAlpha = 0.06;
    context.beginPath();
    for (let place = 0; place < places; place += 1) context.lineTo(line[2 * place] ?? 0, line[2 * place + 1] ?? 0);
    context.fill();
  }
  for (let step = 0; step < look.steps; step += 1) {
    context.globalAlpha = (look.alphas[step] ?? 0) * 0.6;
    context.beginPath();
    for (let place = step * BENDS; place < places; place += 1) {
      context.lineTo(outline[4 * place] ?? 0, outline[4 * place + 1] ?? 0);
    }
    for (let place = places - 1; place >= step * BENDS; place -= 1) {
      context.lineTo(outline[4 * place + 2] ?? 0, outline[4 * place + 3] ?? 0);
    }
    context.fill();
  }
  context.globalAlpha = 1;
}

/** Where agents will stand, firmer toward the last. */
export function drawPlaces(context: CanvasRenderingContext2D, frame: Frame, places: readonly Point[]): void {
  const radius = clamp(0.31 * closest(frame, places), 1.7, LARGEST);
  const color = frame.palette.shown(UNGROUPED_COLOR);
  places.forEach(([x, y], index) => {
    const px = frame.screenX(x);
    const py = frame.screenY(y);
    context.globalAlpha = 1;
    context.fillStyle = frame.palette.sheet;
    context.beginPath();
    context.arc(px, py, radius + haloWidth(radius), 0, 2 * Math.PI);
    context.fill();
    context.globalAlpha = 0.35 + 0.65 * ((index + 1) / places.length);
    context.fillStyle = color;
    context.beginPath();
    context.arc(px, py, radius, 0, 2 * Math.PI);
    context.fill();
  });
  context.globalAlpha = 1;
}

/** Screen places along the stroke, `pieces` equal lengths apart: a fast stroke is as smooth as a slow one. */
function evenly(frame: Frame, stroke: readonly Point[], pieces: number): Float32Array {
  const xs = stroke.map(([x]) => frame.screenX(x));
  const ys = stroke.map(([, y]) => frame.screenY(y));
  const along = [0];
  for (let k = 1; k < stroke.length; k += 1) {
    const step = Math.hypot((xs[k] ?? 0) - (xs[k - 1] ?? 0), (ys[k] ?? 0) - (ys[k - 1] ?? 0));
    along.push((along[k - 1] ?? 0) + step);
  }
  const length = along[along.length - 1] ?? 0;
  const line = new Float32Array(2 * (pieces + 1));
  let k = 0;
  for (let piece = 0; piece <= pieces; piece += 1) {
    const wanted = (length * piece) / pieces;
    while (k < stroke.length - 2 && (along[k + 1] ?? 0) < wanted) k += 1;
    const span = (along[k + 1] ?? 0) - (along[k] ?? 0);
    const share = span > 0 ? (wanted - (along[k] ?? 0)) / span : 0;
    line[2 * piece] = (xs[k] ?? 0) + ((xs[k + 1] ?? 0) - (xs[k] ?? 0)) * share;
    line[2 * piece + 1] = (ys[k] ?? 0) + ((ys[k + 1] ?? 0) - (ys[k] ?? 0)) * share;
  }
  return line;
}

/** Spacing of the first places on the screen: they are even by design. */
function closest(frame: Frame, places: readonly Point[]): number {
  let nearest = Number.POSITIVE_INFINITY;
  const [first] = places;
  if (!first) return nearest;
  for (const [x, y] of places.slice(1)) nearest = Math.min(nearest, Math.hypot(x - first[0], y - first[1]));
  return nearest * frame.camera.scale;
}
