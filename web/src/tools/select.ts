import { boxOf } from "../document/box";
import type { Point } from "../document/formation";
import { picked, pickedInside } from "../document/pick";
import { selectedAgents } from "../document/queries";
import { mainTrack } from "../document/scene";
import type { Selection } from "../document/selection";
import { toggled } from "../document/sets";
import type { Gesture } from "../document/store";
import type { ScreenPoint } from "../stage/camera";
import { type Handle, handleCursor, selectionBounds } from "../stage/handles";
import { type BoxGesture, boxCommand } from "./box-gesture";
import type { Guide } from "./guides";
import { beginLift, heightSpan, type LiftGesture, liftTo, spanInWords } from "./lift-gesture";
import { announceSelected, beginMarquee, endMarquee, type Marquee, stretchMarquee } from "./marquee";
import { beginMove, type MoveGesture, moveTo } from "./move-gesture";
import { agentSelection, type Editor, isDrag, NO_OVERLAY, type Pointing, type Press, type Tool } from "./tool";

type SelectState =
  /** `height` is said of the handle to lift, as it is under the pointer. */
  | { readonly kind: "idle"; readonly over: "stage" | "agent" | Handle; readonly height: string | null }
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
      /** Seen from the front, where up is height. */
      readonly height: { readonly at: Point; readonly words: string } | null;
    }
  | { readonly kind: "boxing"; readonly gesture: Gesture; readonly box: BoxGesture }
  | {
      readonly kind: "lifting";
      readonly gesture: Gesture;
      readonly lift: LiftGesture;
      readonly by: number;
      readonly height: string;
    }
  | Marquee;

const IDLE: SelectState = { kind: "idle", over: "stage", height: null };

/** Click, marquee, move, turn, scale and lift. */
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
        if (last.kind === "brushing") endMarquee(last, event, editor);
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
    if (state.kind === "moving" && (state.guides.length > 0 || state.height)) {
      return { kind: "guides", lines: state.guides, height: state.height };
    }
    if (state.kind === "lifting") return { kind: "lift", by: state.by, words: state.height };
    if (state.kind === "idle" && state.height !== null) return { kind: "lift", by: 0, words: state.height };
    return NO_OVERLAY;
  },
  cursor(state) {
    if (state.kind === "moving" || state.kind === "pointing") return "move";
    if (state.kind === "lifting") return handleCursor("lift");
    const handle = state.kind === "boxing" ? state.box.handle : state.kind === "idle" ? state.over : "stage";
    if (handle === "agent") return "move";
    return handle === "stage" ? "default" : handleCursor(handle);
  },
};

function press(event: Press, editor: Editor): SelectState {
  if (event.isBeside) return beginMarquee(event, editor);
  const { document } = editor;
  const scene = document.scene.peek();
  const selected = selectedAgents(scene, document.selection.peek());
  const handle = editor.handleAt(event);
  const lift = handle === "lift" ? beginLift(editor, event.at, selected) : null;
  if (lift) {
    const height = spanInWords(lift.span, editor);
    return { kind: "lifting", gesture: document.beginGesture(), lift, by: 0, height };
  }
  const bounds = selectionBounds(mainTrack(scene).keyframes[editor.keyframe]?.positions.xy ?? [], selected);
  if (handle && handle !== "lift" && bounds) {
    const box = { handle, origin: event.at, bounds, keyframe: editor.keyframe, agents: selected };
    return { kind: "boxing", gesture: document.beginGesture(), box };
  }
  const agent = editor.agentAt(event);
  if (agent === null) return beginMarquee(event, editor);
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
      const gesture = editor.document.beginGesture();
      return drag({ kind: "moving", gesture, move, guides: [], height: null }, event, editor);
    }
    case "moving": {
      const { command, guides } = moveTo(state.move, event, editor);
      state.gesture.preview(command);
      const height = editor.isUpright ? uprightHeight(state.move, event, editor) : null;
      return { ...state, guides: guides.map((guide) => inWords(guide, editor)), height };
    }
    case "boxing":
      state.gesture.preview(boxCommand(state.box, event));
      return state;
    case "lifting": {
      const { command, by } = liftTo(state.lift, event, editor);
      state.gesture.preview(command);
      const { lowest, highest } = state.lift.span;
      return { ...state, by, height: spanInWords({ lowest: lowest + by, highest: highest + by }, editor) };
    }
    case "brushing":
      return stretchMarquee(state, event, editor);
  }
}

function hover(event: Pointing, editor: Editor): SelectState {
  const over = editor.handleAt(event) ?? (editor.agentAt(event) === null ? "stage" : "agent");
  const { scene, selection } = editor.document;
  const span = over === "lift" ? heightSpan(editor, selectedAgents(scene.peek(), selection.peek())) : null;
  return { kind: "idle", over, height: span && spanInWords(span, editor) };
}

function closeGesture(state: SelectState, how: "commit" | "cancel"): void {
  if (state.kind === "moving" || state.kind === "boxing" || state.kind === "lifting") state.gesture[how]();
}

/** How high the moved agents are, beside the pointer. */
function uprightHeight({ keyframe, agents }: MoveGesture, { at }: Pointing, editor: Editor) {
  const positions = mainTrack(editor.document.scene.peek()).keyframes[keyframe]?.positions;
  const box = positions && boxOf(positions, agents);
  return box ? { at, words: spanInWords({ lowest: box.min[1], highest: box.max[1] }, editor) } : null;
}

function inWords({ from, to, gap }: Guide, editor: Editor) {
  return { from, to, gap: gap === null ? null : editor.inWords(gap) };
}
