import { computed, effect, type ReadonlySignal, signal } from "@preact/signals";
import type { Point } from "../document/formation";
import { outside } from "../document/pick";
import { groupLabel, keyframeLabel } from "../document/queries";
import { mainTrack } from "../document/scene";
import { momentAt } from "../document/timing";
import { createEditor, type ToolParts } from "./create-editor";
import { drawTool } from "./draw";
import { groupTool } from "./group";
import { obstacleTool } from "./obstacle";
import { panTool } from "./pan";
import { settleInMiddle, settleInView } from "./place";
import { selectTool, unitAt } from "./select";
import { shapeTool } from "./shape";
import { tieTool } from "./tie";
import { type Editor, NO_OVERLAY, type Press, type Tool, type ToolEvent } from "./tool";
import type { Overlay, Toolbox, ToolName } from "./toolbox";

/** The tools themselves, at work; loaded when the first is wanted. */
export interface Workbench {
  readonly overlay: ReadonlySignal<Overlay>;
  readonly cursor: ReadonlySignal<string>;
  send(event: ToolEvent): void;
  /** Gives up the gesture under way, or steps out to the group around what is selected; whether there was either. */
  cancel(): boolean;
  placeInMiddle(): void;
  placeInView(places: readonly Point[], label: string): void;
}

export type Settings = Pick<Toolbox, "active" | "shape" | "spacing" | "tieScope">;

export function createWorkbench(parts: ToolParts, settings: Settings): Workbench {
  const { active, shape } = settings;
  const editor = createEditor(parts, settings);
  const hands: Readonly<Record<ToolName, Hand>> = {
    select: inHand(selectTool, editor),
    draw: inHand(drawTool, editor),
    shape: inHand(shapeTool, editor),
    tie: inHand(tieTool, editor),
    group: inHand(groupTool, editor),
    obstacle: inHand(obstacleTool, editor),
    pan: inHand(panTool, editor),
  };
  let isPressed = false;
  /** The rest of a press that only stopped the show. */
  let isSwallowed = false;

  function press(event: Press): void {
    const meaning = settlePress(event, active.peek(), parts, editor);
    isPressed = true;
    isSwallowed = meaning === "nothing";
    if (!isSwallowed) hands[active.peek()].send(meaning === "box" ? { ...event, isBeside: true } : event);
  }

  function giveUp(): boolean {
    const hand = hands[active.peek()];
    // A polygon stays under way between its clicks.
    const wasAtWork = isPressed || hand.overlay.peek().kind === "outline";
    isPressed = false;
    isSwallowed = false;
    hand.send({ kind: "cancel" });
    return wasAtWork;
  }

  function stepOut(): boolean {
    const { document, announce } = parts;
    const around = outside(document.scene.peek(), document.selection.peek());
    if (!editor.areGroupsShown || around.kind !== "group") return false;
    document.selection.value = around;
    announce(`${groupLabel(document.scene.peek(), around.path)} selected`);
    return true;
  }

  // A tool that is put away gives up what it was doing.
  let last = active.peek();
  effect(() => {
    const next = active.value;
    if (next === last) return;
    hands[last].send({ kind: "cancel" });
    isPressed = false;
    last = next;
  });

  return {
    overlay: computed(() => hands[active.value].overlay.value),
    cursor: computed(() => hands[active.value].cursor.value),
    send(event) {
      if (event.kind === "cancel") {
        giveUp();
        return;
      }
      if (event.kind === "press") press(event);
      parts.view.hovered.value = isPressed ? null : editor.agentAt(event);
      if (event.kind !== "press" && !isSwallowed) hands[active.peek()].send(event);
      if (event.kind === "release") {
        isPressed = false;
        isSwallowed = false;
      }
    },
    cancel: () => giveUp() || stepOut(),
    placeInMiddle() {
      const tool = active.peek();
      hands[tool].settle();
      if (tool !== "draw" && tool !== "shape") return;
      settleShow(parts);
      void settleInMiddle(editor, tool === "draw" ? "line" : shape.peek());
    },
    placeInView(places, label) {
      settleShow(parts);
      void settleInView(editor, places, label);
    },
  };
}

/** Edits happen at a keyframe: while agents move, the nearest is gone to, and it is said. Whether they moved. */
function settleShow({ document, playback, announce }: ToolParts): boolean {
  playback.pause();
  const scene = document.scene.peek();
  const moment = momentAt(scene, playback.time.peek());
  document.activeKeyframe.value = moment.kind === "standing" ? moment.keyframe : moment.nearest;
  if (moment.kind === "standing") return false;
  playback.seek(mainTrack(scene).keyframes[moment.nearest]?.time ?? 0);
  announce(`${keyframeLabel(scene, moment.nearest)}: changes are made at keyframes`);
  return true;
}

/**
 * What a press is still meant for once the nearest keyframe was gone to, where what was pressed is somewhere else. A box
 * begun beside everybody goes on; an agent is only selected.
 */
function settlePress(press: Press, tool: ToolName, parts: ToolParts, editor: Editor): "all" | "box" | "nothing" {
  // Neither the view nor what stands on the stage belongs to a keyframe.
  if (tool === "pan" || tool === "obstacle") return "all";
  const agent = editor.agentAt(press);
  const isOnHandle = editor.handleAt(press) !== null;
  const wasMoving = settleShow(parts);
  if (!wasMoving || tool === "draw" || tool === "shape") return "all";
  if (agent === null) return tool !== "tie" && !isOnHandle ? "box" : "nothing";
  const alone = { kind: "agents", agents: new Set([agent]) } as const;
  parts.document.selection.value = tool === "select" ? unitAt(agent, press, editor) : alone;
  return "nothing";
}

/** A tool with the state it is in. */
interface Hand {
  send(event: ToolEvent): void;
  settle(): void;
  readonly overlay: ReadonlySignal<Overlay>;
  readonly cursor: ReadonlySignal<string>;
}

function inHand<State>(tool: Tool<State>, editor: Editor): Hand {
  const state = signal(tool.start);
  return {
    send(event) {
      state.value = tool.step(state.peek(), event, editor);
    },
    settle() {
      if (tool.settle) state.value = tool.settle(state.peek(), editor);
    },
    overlay: computed(() => tool.overlay(state.value) ?? NO_OVERLAY),
    cursor: computed(() => tool.cursor(state.value)),
  };
}
