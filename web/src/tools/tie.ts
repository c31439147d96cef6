import { addTie, type TieScope, WHOLE_SCENE } from "../document/commands/ties";
import type { Point } from "../document/formation";
import { agentLabel } from "../document/queries";
import { NOTHING } from "../document/selection";
import { type Editor, NO_OVERLAY, type Pointing, type Press, type Tool } from "./tool";

type TieState =
  | { readonly kind: "idle"; readonly isOver: boolean }
  | { readonly kind: "pulling"; readonly from: number; readonly to: Point; readonly target: number | null };

const IDLE: TieState = { kind: "idle", isOver: false };

/** Pull from agent to agent to tie them; click a tie to select it. */
export const tieTool: Tool<TieState> = {
  start: IDLE,
  step(state, event, editor) {
    switch (event.kind) {
      case "cancel":
        return IDLE;
      case "press":
        return press(event, editor);
      case "move":
        return state.kind === "idle" ? hover(event, editor) : pull(state.from, event, editor);
      case "release":
        if (state.kind === "pulling") finish(pull(state.from, event, editor), editor);
        return IDLE;
    }
  },
  overlay: (state) => (state.kind === "pulling" ? { ...state, kind: "tie" } : NO_OVERLAY),
  cursor: (state) => (state.kind === "idle" && !state.isOver ? "default" : "pointer"),
};

type Pulling = Extract<TieState, { kind: "pulling" }>;

function press(event: Press, editor: Editor): TieState {
  const agent = editor.agentAt(event);
  if (agent !== null) return { kind: "pulling", from: agent, to: event.at, target: null };
  const tie = editor.tieAt(event);
  editor.document.selection.value = tie ? { kind: "tie", a: tie[0], b: tie[1] } : NOTHING;
  return { kind: "idle", isOver: tie !== null };
}

function hover(event: Pointing, editor: Editor): TieState {
  return { kind: "idle", isOver: editor.agentAt(event) !== null || editor.tieAt(event) !== null };
}

function pull(from: number, event: Pointing, editor: Editor): Pulling {
  const over = editor.agentAt(event);
  return { kind: "pulling", from, to: event.at, target: over === from ? null : over };
}

function finish({ from, target }: Pulling, editor: Editor): void {
  const { document, keyframe } = editor;
  if (target === null) return;
  const scope: TieScope = editor.tieScope === "scene" ? WHOLE_SCENE : { kind: "keyframe", index: keyframe };
  document.perform(addTie(scope, from, target));
  document.selection.value = { kind: "tie", a: Math.min(from, target), b: Math.max(from, target) };
  const scene = document.scene.peek();
  editor.announce(`${agentLabel(scene, from)} tied to ${agentLabel(scene, target)}`);
}
