import type { Point } from "../document/formation";
import { obstacleLabel } from "../document/obstacle";
import { agentLabel, selectedAgents } from "../document/queries";
import type { Selection } from "../document/selection";
import { toggled } from "../document/sets";
import { agentSelection, type Editor, metersOf, type Pointing, type Press } from "./tool";

/** A box that selects who stands in it while it is drawn. */
export interface Marquee {
  readonly kind: "brushing";
  readonly origin: Point;
  readonly current: Point;
  /** What Escape brings back. */
  readonly before: Selection;
  readonly held: ReadonlySet<number>;
  readonly way: "replace" | "add" | "toggle";
}

/** Pixels a marquee may have and still be a click. */
const CLICK = 4;

/** Shift adds to what is selected, Ctrl turns it over. */
export function beginMarquee(event: Press, editor: Editor): Marquee {
  const { document } = editor;
  const before = document.selection.peek();
  const way = event.ctrl ? "toggle" : event.shift ? "add" : "replace";
  const held = way === "replace" ? new Set<number>() : selectedAgents(document.scene.peek(), before);
  return stretchMarquee({ kind: "brushing", origin: event.at, current: event.at, before, held, way }, event, editor);
}

export function stretchMarquee(state: Marquee, event: Pointing, editor: Editor): Marquee {
  const inside = new Set(editor.agentsWithin(state.origin, event.at));
  const agents = state.way === "toggle" ? toggled(state.held, inside) : new Set([...state.held, ...inside]);
  editor.document.selection.value = agentSelection(agents);
  return { ...state, current: event.at };
}

/** A marquee that stayed a click, beside all agents, may mean the obstacle that stands there. */
export function endMarquee({ origin }: Marquee, event: Pointing, editor: Editor): void {
  const { document } = editor;
  const isClick = Math.hypot(event.at[0] - origin[0], event.at[1] - origin[1]) <= metersOf(CLICK, editor);
  if (isClick && !event.shift && !event.ctrl && document.selection.peek().kind === "none") {
    const index = editor.obstacleAt(event);
    if (index !== null) document.selection.value = { kind: "obstacle", index };
  }
  announceSelected(editor);
}

export function announceSelected(editor: Editor): void {
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
