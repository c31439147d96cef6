import { addToGroup, makeGroup, removeFromGroup } from "../document/commands/groups";
import type { Point } from "../document/formation";
import { groupWithSet } from "../document/group-with-set";
import { groupOf } from "../document/groups";
import { groupLabel } from "../document/queries";
import type { GroupPath } from "../document/scene";
import { NOTHING } from "../document/selection";
import type { ScreenPoint } from "../stage/camera";
import { agentSelection, type Editor, isDrag, NO_OVERLAY, type Pointing, type Tool } from "./tool";

type GroupState =
  | { readonly kind: "idle"; readonly isOver: boolean }
  | { readonly kind: "pointing"; readonly origin: Point; readonly screen: ScreenPoint }
  | { readonly kind: "brushing"; readonly origin: Point; readonly current: Point };

const IDLE: GroupState = { kind: "idle", isOver: false };

/**
 * Draw a box around agents to make them a group; click an agent to select its group.
 *
 * With a group selected, Shift adds what is clicked or boxed to it, and Ctrl takes it out.
 */
export const groupTool: Tool<GroupState> = {
  start: IDLE,
  step(state, event, editor) {
    switch (event.kind) {
      case "cancel":
        return IDLE;
      case "press":
        if (event.isBeside) return { kind: "brushing", origin: event.at, current: event.at };
        return { kind: "pointing", origin: event.at, screen: event.screen };
      case "move":
        if (state.kind === "idle") return { kind: "idle", isOver: editor.agentAt(event) !== null };
        if (state.kind === "pointing" && !isDrag(state.screen, event)) return state;
        return { kind: "brushing", origin: state.origin, current: event.at };
      case "release":
        if (state.kind === "pointing") click(event, editor);
        if (state.kind === "brushing") group(new Set(editor.agentsWithin(state.origin, event.at)), event, editor);
        return IDLE;
    }
  },
  overlay: (state) =>
    state.kind === "brushing" ? { kind: "marquee", from: state.origin, to: state.current } : NO_OVERLAY,
  cursor: (state) => (state.kind === "idle" && state.isOver ? "pointer" : "crosshair"),
};

function click(event: Pointing, editor: Editor): void {
  const { document } = editor;
  const agent = editor.agentAt(event);
  if (agent === null) {
    document.selection.value = NOTHING;
    return;
  }
  if (selectedGroup(editor) && (event.shift || event.ctrl)) {
    group(new Set([agent]), event, editor);
    return;
  }
  const path = groupOf(document.scene.peek().groups, agent);
  document.selection.value = path ? { kind: "group", path } : { kind: "agents", agents: new Set([agent]) };
}

function group(agents: ReadonlySet<number>, event: Pointing, editor: Editor): void {
  const { document } = editor;
  const path = selectedGroup(editor);
  if (agents.size === 0) {
    if (!path) document.selection.value = NOTHING;
    return;
  }
  if (path && event.shift) {
    document.perform(addToGroup(path, agents));
    editor.announce(
      `${agents.size} agents added to ${groupLabel(document.scene.peek(), selectedGroup(editor) ?? path)}`,
    );
    return;
  }
  if (path && event.ctrl) {
    document.perform(removeFromGroup(path, agents));
    editor.announce(`${agents.size} agents taken out`);
    return;
  }
  document.perform(makeGroup(agents));
  const made = groupWithSet(document.scene.peek().groups, agents);
  document.selection.value = made ? { kind: "group", path: made } : agentSelection(agents);
  if (made) editor.announce(`${groupLabel(document.scene.peek(), made)}: ${agents.size} agents`);
  else editor.warn("No group was made.", "A scene has at most 1,000 groups, 8 deep.");
}

function selectedGroup({ document }: Editor): GroupPath | null {
  const selection = document.selection.peek();
  return selection.kind === "group" ? selection.path : null;
}
