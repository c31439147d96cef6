import { tieToObstacle } from "../document/commands/obstacle-ties";
import { addTie, type TieScope, WHOLE_SCENE } from "../document/commands/ties";
import type { Point } from "../document/formation";
import { obstacleLabel } from "../document/obstacle";
import { agentLabel } from "../document/queries";
import { NOTHING } from "../document/selection";
import { type Editor, NO_OVERLAY, type Pointing, type Press, type Tool } from "./tool";

type TieState =
  | { readonly kind: "idle"; readonly isOver: boolean }
  | {
      readonly kind: "pulling";
      readonly from: number;
      readonly to: Point;
      /** The agent that is reached, or else the obstacle. */
      readonly target: number | null;
      readonly obstacle: number | null;
    };

const IDLE: TieState = { kind: "idle", isOver: false };

/** Pull from agent to agent, or to an obstacle, to tie them; click a tie to select it. */
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
  overlay(state) {
    if (state.kind === "idle") return NO_OVERLAY;
    return { kind: "tie", from: state.from, to: state.to, target: state.target };
  },
  cursor: (state) => (state.kind === "idle" && !state.isOver ? "default" : "pointer"),
};

type Pulling = Extract<TieState, { kind: "pulling" }>;

function press(event: Press, editor: Editor): TieState {
  const agent = editor.agentAt(event);
  if (agent !== null) return { kind: "pulling", from: agent, to: event.at, target: null, obstacle: null };
  const tie = editor.tieAt(event);
  editor.document.selection.value = tie ? { kind: "tie", a: tie[0], b: tie[1] } : NOTHING;
  return { kind: "idle", isOver: tie !== null };
}

function hover(event: Pointing, editor: Editor): TieState {
  return { kind: "idle", isOver: editor.agentAt(event) !== null || editor.tieAt(event) !== null };
}

function pull(from: number, event: Pointing, editor: Editor): Pulling {
  const over = editor.agentAt(event);
  const target = over === from ? null : over;
  const obstacle = target === null ? editor.obstacleAt(event) : null;
  return { kind: "pulling", from, to: event.at, target, obstacle };
}

function finish({ from, target, obstacle }: Pulling, editor: Editor): void {
  const { document, keyframe } = editor;
  const scope: TieScope = editor.tieScope === "scene" ? WHOLE_SCENE : { kind: "keyframe", index: keyframe };
  if (obstacle !== null) {
    document.perform(tieToObstacle(scope, from, obstacle));
    document.selection.value = { kind: "obstacle", index: obstacle };
    const scene = document.scene.peek();
    editor.announce(`${agentLabel(scene, from)} tied to ${obstacleLabel(scene, obstacle)}`);
  }
  if (target === null) return;
  document.perform(addTie(scope, from, target));
  document.selection.value = { kind: "tie", a: Math.min(from, target), b: Math.max(from, target) };
  const scene = document.scene.peek();
  editor.announce(`${agentLabel(scene, from)} tied to ${agentLabel(scene, target)}`);
}
