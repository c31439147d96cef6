import { liftAgents } from "../document/commands/heights";
import type { Point } from "../document/formation";
import { mainTrack } from "../document/scene";
import { nudgeSteps, type Snap, snapOf, snapValue } from "../document/snap";
import type { Command } from "../document/store";
import { nearestMove } from "./guides";
import { type Editor, metersOf, type Pointing } from "./tool";

/** Agents pulled up or down by the handle of their box, and the levels they may be held at. */
export interface LiftGesture {
  readonly origin: Point;
  readonly keyframe: number;
  readonly agents: ReadonlySet<number>;
  readonly span: HeightSpan;
  /** Heights of the agents that stay, and the ground, meters. */
  readonly levels: readonly number[];
  readonly snap: Snap;
  /** Shift lifts by multiples of it, meters. */
  readonly step: number;
}

/** How high the lowest and the highest of some agents are, meters. */
export interface HeightSpan {
  readonly lowest: number;
  readonly highest: number;
}

/** Pixels within which a level draws a lifted agent to it. */
const REACH = 6;

/** Null when there is nobody to lift. */
export function beginLift(editor: Editor, origin: Point, agents: ReadonlySet<number>): LiftGesture | null {
  const { keyframe } = editor;
  const scene = editor.document.scene.peek();
  const positions = mainTrack(scene).keyframes[keyframe]?.positions;
  const span = heightSpan(editor, agents);
  if (!positions || !span) return null;
  const levels = new Set([0]);
  positions.heights?.forEach((height, agent) => {
    if (!agents.has(agent)) levels.add(height);
  });
  return {
    origin,
    keyframe,
    agents,
    span,
    levels: [...levels],
    snap: snapOf(scene),
    step: nudgeSteps(scene).far,
  };
}

/** The lift to where the pointer is, as far up as on the screen: Shift goes by whole steps, Alt lets levels be. */
export function liftTo(
  gesture: LiftGesture,
  { at, shift, alt }: Pointing,
  editor: Editor,
): { readonly command: Command; readonly by: number } {
  const { origin, keyframe, agents, span, levels, snap, step } = gesture;
  const pulled = at[1] - origin[1];
  const free = snapValue(pulled, snap);
  const held = () => nearestMove([span.lowest, span.highest], levels, pulled, metersOf(REACH, editor));
  const by = shift ? Math.round(pulled / step) * step + 0 : alt ? free : (held() ?? free);
  return { command: liftAgents(keyframe, agents, by), by };
}

/** How high some agents are at the keyframe being edited; null when there is none of them. */
export function heightSpan(editor: Editor, agents: Iterable<number>): HeightSpan | null {
  const positions = mainTrack(editor.document.scene.peek()).keyframes[editor.keyframe]?.positions;
  let [lowest, highest] = [Infinity, -Infinity];
  for (const agent of agents) {
    const height = positions?.height(agent) ?? Number.NaN;
    lowest = Math.min(lowest, height);
    highest = Math.max(highest, height);
  }
  return lowest <= highest ? { lowest, highest } : null;
}

/** `z 1.20 m`, or from the lowest to the highest. */
export function spanInWords({ lowest, highest }: HeightSpan, editor: Editor): string {
  const [low, high] = [editor.inWords(lowest), editor.inWords(highest)];
  return low === high ? `z ${low}` : `z ${low} to ${high}`;
}
