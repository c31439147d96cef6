import type { Point } from "../document/formation";
import type { Effort } from "../shapes/fill";
import { extended, isClosedStroke, isMeant, type StrokeKind, smoothed, strokePlaces } from "../shapes/stroke";
import { placementOf, settlePlaces, spacingFor } from "./place";
import { type Editor, metersOf, NO_OVERLAY, type Pointing, type Tool } from "./tool";

type DrawState =
  | { readonly kind: "idle" }
  | {
      readonly kind: "drawing";
      readonly stroke: readonly Point[];
      readonly becomes: StrokeKind;
      readonly places: readonly Point[];
    };

const IDLE: DrawState = { kind: "idle" };

/** Pixels between the points kept of a stroke. */
const GRAIN = 3;
/** A stroke that ends this near to its start, in pixels, is closed. */
const CLOSING = 16;
/** Pixels a stroke must go to be one; less is a click. */
const SHORTEST = 10;

/** Freehand: agents evenly along the stroke, or filling what a closed one encloses; Alt keeps to its outline. */
export const drawTool: Tool<DrawState> = {
  start: IDLE,
  step(state, event, editor) {
    if (event.kind === "cancel") return IDLE;
    if (event.kind === "press") return drawn([event.at], event, editor, "preview");
    if (state.kind === "idle") return state;
    const stroke = extended(state.stroke, event.at, metersOf(GRAIN, editor));
    if (event.kind === "move") return stroke === state.stroke ? state : drawn(stroke, event, editor, "preview");
    finish(drawn(stroke, event, editor, "full"), event, editor);
    return IDLE;
  },
  overlay(state) {
    if (state.kind === "idle") return NO_OVERLAY;
    return { kind: "stroke", stroke: state.stroke, isClosed: state.becomes !== "open", places: state.places };
  },
  cursor: () => "crosshair",
};

type Drawing = Extract<DrawState, { kind: "drawing" }>;

function drawn(stroke: readonly Point[], { alt }: Pointing, editor: Editor, effort: Effort): Drawing {
  const isClosed = isClosedStroke(stroke, metersOf(CLOSING, editor));
  const becomes = isClosed ? (alt ? "outline" : "filled") : "open";
  const places = strokePlaces(smoothed(stroke), becomes, spacingFor(editor), effort);
  return { kind: "drawing", stroke, becomes, places };
}

function finish({ stroke, places }: Drawing, { at }: Pointing, editor: Editor): void {
  if (isMeant(stroke, metersOf(SHORTEST, editor))) {
    void settlePlaces(editor, places, "Draw agents");
    return;
  }
  const placement = placementOf(editor);
  if (placement.kind === "add") void settlePlaces(editor, [at], "Add agent");
  else editor.announce(`Pull a stroke to place agents. ${placement.reason}`);
}
