import type { Point } from "../document/formation";
import { obstacleLabel } from "../document/obstacle";
import { picked, pickedInside } from "../document/pick";
import { agentLabel, selectedAgents } from "../document/queries";
import { mainTrack } from "../document/scene";
import type { Selection } from "../document/selection";
import { toggled } from "../document/sets";
import type { Gesture } from "../document/store";
import type { ScreenPoint } from "../stage/camera";
import { type Handle, handleCursor, selectionBounds } from "../stage/handles";
import { type BoxGesture, boxCommand } from "./box-gesture";
import type { Guide } from "./guides";
import { beginMove, type MoveGesture, moveTo } from "./move-gesture";
import {
  agentSelection,
  type Editor,
  isDrag,
  metersOf,
  NO_OVERLAY,
  type Pointing,
  type Press,
  type Tool,
} from "./tool";

type SelectState =
  | { readonly kind: "idle"; readonly over: "stage" | "agent" | Handle }
  /** Pressed on an agent: a click or the start of a move. `onClick` is selected when it stays a click. */
  | {
      readonly kind: "pointing";
      readonly origin: Point;
      readonly screen: ScreenPoint;
      readonly onClick: Selection | null;
    }
  | {
      readonly kind: "moving";
      readonly gesture: Gesture;
      readonly move: MoveGesture;
      readonly guides: readonly { readonly from: Point; readonly to: Point; readonly gap: string | null }[];
    }
  | { readonly kind: "boxing"; readonly gesture: Gesture; readonly box: BoxGesture }
  | {
      readonly kind: "brushing";
      readonly origin: Point;
      readonly current: Point;
      readonly before: Selection;
      readonly held: ReadonlySet<number>;
      readonly way: "replace" | "add" | "toggle";
    };

/** Pixels a marquee may have and still be a click. */
const CLICK = 4;

const IDLE: SelectState = { kind: "idle", over: "stage" };

/** Click, marquee, move, turn and scale. */
export const selectTool: Tool<SelectState> = {
  start: IDLE,
  step(state, event, editor) {
    switch (event.kind) {
      case "press":
        closeGesture(state, "commit");
        return press(event, editor);
      case "move":
        return drag(state, event, editor);
      case "release": {
        const last = drag(state, event, editor);
        if (last.kind === "pointing" && last.onClick) editor.document.selection.value = last.onClick;
        if (last.kind === "brushing") {
          pickObstacle(last.origin, event, editor);
          announceSelected(editor);
        }
        closeGesture(last, "commit");
        return hover(event, editor);
      }
      case "cancel":
        if (state.kind === "brushing") editor.document.selection.value = state.before;
        closeGesture(state, "cancel");
        return IDLE;
    }
  },
  overlay(state) {
    if (state.kind === "brushing") return { kind: "marquee", from: state.origin, to: state.current };
    if (state.kind === "moving" && state.guides.length > 0) return { kind: "guides", lines: state.guides };
    return NO_OVERLAY;
  },
  cursor(state) {
    if (state.kind === "moving" || state.kind === "pointing") return "move";
    const handle = state.kind === "boxing" ? state.box.handle : state.kind === "idle" ? state.over : "stage";
    if (handle === "agent") return "move";
    return handle === "stage" ? "default" : handleCursor(handle);
  },
};

function press(event: Press, editor: Editor): SelectState {
  const { document } = editor;
  const scene = document.scene.peek();
  const selected = selectedAgents(scene, document.selection.peek());
  const handle = editor.handleAt(event);
  const bounds = selectionBounds(mainTrack(scene).keyframes[editor.keyframe]?.positions.xy ?? [], selected);
  if (handle && bounds) {
    const box = { handle, origin: event.at, bounds, keyframe: editor.keyframe, agents: selected };
    return { kind: "boxing", gesture: document.beginGesture(), box };
  }
  const agent = editor.agentAt(event);
  if (agent === null) return beginBrush(event, editor);
  const pointing = { kind: "pointing", origin: event.at, screen: event.screen, onClick: null } as const;
  const current = document.selection.peek();
  const unit = unitAt(agent, event, editor);
  if (event.isDouble) {
    document.selection.value = unit;
    announceSelected(editor);
    return pointing;
  }
  if (event.ctrl) {
    document.selection.value = agentSelection(toggled(selected, selectedAgents(scene, unit)));
    return selected.has(agent) ? IDLE : pointing;
  }
  if (event.shift) {
    document.selection.value = agentSelection(new Set([...selected, ...selectedAgents(scene, unit)]));
    return pointing;
  }
  if (selected.has(agent) && current.kind !== "tie") {
    // A group under the pointer stays as it is; of several agents a click picks the one.
    return { ...pointing, onClick: current.kind === "group" ? null : unit };
  }
  document.selection.value = unit;
  return pointing;
}

/** What a press on an agent is meant for: its group where groups show, or the agent itself. */
export function unitAt(agent: number, { isDouble }: Press, { document, areGroupsShown }: Editor): Selection {
  const scene = document.scene.peek();
  const selection = document.selection.peek();
  if (!areGroupsShown) return { kind: "agents", agents: new Set([agent]) };
  return isDouble ? pickedInside(scene, selection, agent) : picked(scene, selection, agent);
}

function drag(state: SelectState, event: Pointing, editor: Editor): SelectState {
  switch (state.kind) {
    case "idle":
      return hover(event, editor);
    case "pointing": {
      if (!isDrag(state.screen, event)) return state;
      const { scene, selection } = editor.document;
      const move = beginMove(editor, state.origin, selectedAgents(scene.peek(), selection.peek()));
      if (!move) return IDLE;
      return drag({ kind: "moving", gesture: editor.document.beginGesture(), move, guides: [] }, event, editor);
    }
    case "moving": {
      const { command, guides } = moveTo(state.move, event, editor);
      state.gesture.preview(command);
      return { ...state, guides: guides.map((guide) => inWords(guide, editor)) };
    }
    case "boxing":
      state.gesture.preview(boxCommand(state.box, event));
      return state;
    case "brushing":
      return brush(state, event, editor);
  }
}

function beginBrush(event: Press, editor: Editor): SelectState {
  const { document } = editor;
  const before = document.selection.peek();
  const way = event.ctrl ? "toggle" : event.shift ? "add" : "replace";
  const held = way === "replace" ? new Set<number>() : selectedAgents(document.scene.peek(), before);
  return brush({ kind: "brushing", origin: event.at, current: event.at, before, held, way }, event, editor);
}

function brush(state: Extract<SelectState, { kind: "brushing" }>, event: Pointing, editor: Editor): SelectState {
  const inside = new Set(editor.agentsWithin(state.origin, event.at));
  const agents = state.way === "toggle" ? toggled(state.held, inside) : new Set([...state.held, ...inside]);
  editor.document.selection.value = agentSelection(agents);
  return { ...state, current: event.at };
}

/** A click beside all agents may mean what stands there. */
function pickObstacle(origin: Point, event: Pointing, editor: Editor): void {
  const { document } = editor;
  const isClick = Math.hypot(event.at[0] - origin[0], event.at[1] - origin[1]) <= metersOf(CLICK, editor);
  if (!isClick || event.shift || event.ctrl || document.selection.peek().kind !== "none") return;
  const index = editor.obstacleAt(event);
  if (index !== null) document.selection.value = { kind: "obstacle", index };
}

function hover(event: Pointing, editor: Editor): SelectState {
  const over = editor.handleAt(event) ?? (editor.agentAt(event) === null ? "stage" : "agent");
  return { kind: "idle", over };
}

function closeGesture(state: SelectState, how: "commit" | "cancel"): void {
  if (state.kind === "moving" || state.kind === "boxing") state.gesture[how]();
}

function announceSelected(editor: Editor): void {
  const scene = editor.document.scene.peek();
  const selection = editor.document.selection.peek();
  if (selection.kind === "obstacle") {
    editor.announce(`${obstacleLabel(scene, selection.index)} selected`);
    return;
  }
  const [first, ...rest] = selectedAgents(scene, selection);
  if (first === undefined) editor.announce("Nothing selected");
  else
    editor.announce(rest.length === 0 ? `${agentLabel(scene, first)} selected` : `${rest.length + 1} agents selected`);
}

function inWords({ from, to, gap }: Guide, editor: Editor) {
  return { from, to, gap: gap === null ? null : editor.inWords(gap) };
}
