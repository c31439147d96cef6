import { addObstacle, isOutline, setObstacleShape } from "../document/commands/obstacles";
import type { Point } from "../document/formation";
import { crossesItself, obstacleLabel, shapeMoved } from "../document/obstacle";
import type { ObstacleShape } from "../document/scene";
import { NOTHING } from "../document/selection";
import { snapOf, snapPoint } from "../document/snap";
import type { Gesture } from "../document/store";
import { type ScreenPoint, toStage } from "../stage/camera";
import { type Editor, isDrag, metersOf, NO_OVERLAY, type Pointing, type Press, type Tool } from "./tool";

type ObstacleState =
  | { readonly kind: "idle"; readonly isOver: boolean }
  /** Pressed on the stage: a circle when it is dragged, else the first corner of a polygon. */
  | { readonly kind: "pressed"; readonly at: Point; readonly screen: ScreenPoint }
  | { readonly kind: "circling"; readonly center: Point; readonly radius: number }
  /** Between the clicks of a polygon; `at` is where the next corner would be. */
  | { readonly kind: "cornering"; readonly corners: readonly Point[]; readonly at: Point; readonly isPressed: boolean }
  | { readonly kind: "grabbed"; readonly index: number; readonly origin: Point; readonly screen: ScreenPoint }
  | {
      readonly kind: "moving";
      readonly index: number;
      readonly origin: Point;
      readonly shape: ObstacleShape;
      readonly gesture: Gesture;
    };

const IDLE: ObstacleState = { kind: "idle", isOver: false };

/** Pixels from the first corner within which a click closes a polygon. */
const CLOSING = 12;
/** Radius of a circle placed without a pointer, meters. */
const PLACED_RADIUS = 2;

/** A drag makes a circle, clicks make a polygon; an obstacle that is there is selected and moved. */
export const obstacleTool: Tool<ObstacleState> = {
  start: IDLE,
  step(state, event, editor) {
    switch (event.kind) {
      case "press":
        return press(state, event, editor);
      case "move":
        return move(state, event, editor);
      case "release":
        return release(move(state, event, editor), editor);
      case "cancel":
        if (state.kind === "moving") state.gesture.cancel();
        return IDLE;
    }
  },
  settle(state, editor) {
    if (state.kind === "cornering") return close(state.corners, editor);
    const middle = toStage(editor.camera, { x: editor.size.width / 2, y: editor.size.height / 2 });
    place({ kind: "circle", center: snapped(middle, editor), radius: PLACED_RADIUS }, editor);
    return IDLE;
  },
  overlay(state) {
    switch (state.kind) {
      case "circling":
        return { kind: "outline", shape: { kind: "circle", center: state.center, radius: state.radius }, next: null };
      case "cornering":
        return { kind: "outline", shape: { kind: "polygon", points: state.corners }, next: state.at };
      default:
        return NO_OVERLAY;
    }
  },
  cursor(state) {
    if (state.kind === "moving" || state.kind === "grabbed") return "move";
    return state.kind === "idle" && state.isOver ? "move" : "crosshair";
  },
};

function press(state: ObstacleState, event: Press, editor: Editor): ObstacleState {
  const at = snapped(event.at, editor);
  if (state.kind === "cornering") {
    if (event.isDouble || isAtFirst(state.corners, event, editor)) return close(state.corners, editor);
    return { ...state, at, isPressed: true };
  }
  const index = editor.obstacleAt(event);
  editor.document.selection.value = index === null ? NOTHING : { kind: "obstacle", index };
  if (index === null) return { kind: "pressed", at, screen: event.screen };
  return { kind: "grabbed", index, origin: event.at, screen: event.screen };
}

function move(state: ObstacleState, event: Pointing, editor: Editor): ObstacleState {
  switch (state.kind) {
    case "idle":
      return { kind: "idle", isOver: editor.obstacleAt(event) !== null };
    case "pressed":
      return isDrag(state.screen, event) ? circle(state.at, event) : state;
    case "circling":
      return circle(state.center, event);
    case "cornering":
      return { ...state, at: snapped(event.at, editor) };
    case "grabbed": {
      const { document } = editor;
      const shape = document.scene.peek().obstacles[state.index]?.shape;
      if (!shape || !isDrag(state.screen, event)) return state;
      const { index, origin } = state;
      return move({ kind: "moving", index, origin, shape, gesture: document.beginGesture() }, event, editor);
    }
    case "moving": {
      const by = snapped([event.at[0] - state.origin[0], event.at[1] - state.origin[1]], editor);
      state.gesture.preview(setObstacleShape(state.index, shapeMoved(state.shape, by), "Move obstacle"));
      return state;
    }
  }
}

function release(state: ObstacleState, editor: Editor): ObstacleState {
  switch (state.kind) {
    case "pressed":
      return { kind: "cornering", corners: [state.at], at: state.at, isPressed: false };
    case "circling":
      place({ kind: "circle", center: state.center, radius: state.radius }, editor);
      return IDLE;
    case "cornering":
      return state.isPressed ? { ...state, corners: [...state.corners, state.at], isPressed: false } : state;
    case "moving":
      state.gesture.commit();
      return { kind: "idle", isOver: true };
    default:
      return IDLE;
  }
}

/** To the centimeter: a radius that can be typed again. */
function circle(center: Point, { at }: Pointing): ObstacleState {
  const radius = Math.round(100 * Math.hypot(at[0] - center[0], at[1] - center[1])) / 100;
  return { kind: "circling", center, radius };
}

function isAtFirst(corners: readonly Point[], event: Pointing, editor: Editor): boolean {
  const [first] = corners;
  if (!first || corners.length < 3) return false;
  return Math.hypot(event.at[0] - first[0], event.at[1] - first[1]) <= metersOf(CLOSING, editor);
}

/** The polygon as it is; what encloses nothing, or crosses itself, is said and stays open. */
function close(corners: readonly Point[], editor: Editor): ObstacleState {
  const shape: ObstacleShape = { kind: "polygon", points: corners };
  if (isOutline(shape)) {
    place(shape, editor);
    return IDLE;
  }
  const help = crossesItself(corners)
    ? "Two of its sides cross; give the corners in the order in which they lie around it."
    : "A polygon takes three corners that are not in one line.";
  editor.warn("That is no obstacle yet.", help);
  return { kind: "cornering", corners, at: corners.at(-1) ?? [0, 0], isPressed: false };
}

function place(shape: ObstacleShape, editor: Editor): void {
  const { document } = editor;
  const index = document.scene.peek().obstacles.length;
  document.perform(addObstacle(shape));
  const scene = document.scene.peek();
  if (!scene.obstacles[index]) {
    editor.warn("The obstacle was not added.", "A scene has at most 200 obstacles of 200 corners.");
    return;
  }
  document.selection.value = { kind: "obstacle", index };
  editor.announce(`${obstacleLabel(scene, index)} added`);
}

function snapped(at: Point, editor: Editor): Point {
  return snapPoint(at, snapOf(editor.document.scene.peek()));
}
