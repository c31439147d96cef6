import type { Point } from "../document/formation";
import { isDrawn, type PlacedShape, placeShape } from "../shapes/shape";
import { settlePlaces, spacingFor } from "./place";
import { type Editor, metersOf, NO_OVERLAY, type Pointing, type Tool } from "./tool";

type ShapeState =
  | { readonly kind: "idle" }
  | { readonly kind: "dragging"; readonly origin: Point; readonly shape: PlacedShape | null };

const IDLE: ShapeState = { kind: "idle" };

/** Pixels a shape must be dragged to have a size. */
const SMALLEST = 10;

/** Drags a shape out of its corner; Shift makes it as deep as wide, Alt starts at its middle. */
export const shapeTool: Tool<ShapeState> = {
  start: IDLE,
  step(state, event, editor) {
    if (event.kind === "cancel") return IDLE;
    if (event.kind === "press") return { kind: "dragging", origin: event.at, shape: null };
    if (state.kind === "idle") return state;
    const shape = shapeAt(state.origin, event, editor);
    if (event.kind === "move") return { ...state, shape };
    if (shape) void settlePlaces(editor, shape.places, `Place ${editor.shape}`);
    else editor.announce("Drag to give the shape its size");
    return IDLE;
  },
  overlay: (state) => (state.kind === "dragging" && state.shape ? { kind: "shape", ...state.shape } : NO_OVERLAY),
  cursor: () => "crosshair",
};

function shapeAt(origin: Point, pointing: Pointing, editor: Editor): PlacedShape | null {
  if (!isDrawn(origin, pointing.at, metersOf(SMALLEST, editor))) return null;
  const to = pointing.shift ? squared(origin, pointing.at, editor.shape === "line") : pointing.at;
  const from: Point = pointing.alt ? [2 * origin[0] - to[0], 2 * origin[1] - to[1]] : origin;
  return placeShape(editor.shape, from, to, spacingFor(editor));
}

/** The drag as deep as it is wide; a line goes level, upright or at half a right angle instead. */
function squared(from: Point, to: Point, isLine: boolean): Point {
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  if (isLine && Math.abs(dy) < 0.414 * Math.abs(dx)) return [to[0], from[1]];
  if (isLine && Math.abs(dx) < 0.414 * Math.abs(dy)) return [from[0], to[1]];
  const side = Math.max(Math.abs(dx), Math.abs(dy));
  return [from[0] + (dx < 0 ? -side : side), from[1] + (dy < 0 ? -side : side)];
}
