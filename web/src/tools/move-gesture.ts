import { type Box, boxOf } from "../document/box";
import { moveAgents } from "../document/commands/agents";
import type { Point } from "../document/formation";
import { mainTrack } from "../document/scene";
import { type Snap, snapOf, snapPoint } from "../document/snap";
import type { Command } from "../document/store";
import { type Guide, guideMove, nearestMove } from "./guides";
import { type Editor, metersOf, type Pointing } from "./tool";

/** Agents on their way with the pointer, and what they may be held in line with. */
export interface MoveGesture {
  readonly origin: Point;
  readonly keyframe: number;
  readonly agents: ReadonlySet<number>;
  readonly box: Box;
  readonly others: readonly Point[];
  readonly snap: Snap;
}

/** Pixels within which neighbors draw a moved thing into line. */
const REACH = 6;

/** Null when there is nobody to move. */
export function beginMove(editor: Editor, origin: Point, agents: ReadonlySet<number>): MoveGesture | null {
  const scene = editor.document.scene.peek();
  const positions = mainTrack(scene).keyframes[editor.keyframe]?.positions;
  const box = positions && boxOf(positions, agents);
  if (!positions || !box) return null;
  const others = positions.points().filter((_, agent) => !agents.has(agent));
  return { origin, keyframe: editor.keyframe, agents, box, others, snap: snapOf(scene) };
}

/** The move to where the pointer is: Shift keeps to one axis, Alt lets neighbors be. */
export function moveTo(
  gesture: MoveGesture,
  pointing: Pointing,
  editor: Editor,
): { readonly command: Command; readonly guides: readonly Guide[] } {
  const { origin, keyframe, agents, box, others, snap } = gesture;
  const pulled: Point = [pointing.at[0] - origin[0], pointing.at[1] - origin[1]];
  const isAcross = Math.abs(pulled[0]) >= Math.abs(pulled[1]);
  const by: Point = pointing.shift ? (isAcross ? [pulled[0], 0] : [0, pulled[1]]) : pulled;
  if (pointing.alt || pointing.shift) {
    return { command: moveAgents(keyframe, agents, snapPoint(by, snap)), guides: [] };
  }
  const guided = guideMove(box, others, by, metersOf(REACH, editor));
  const free = snapPoint(by, snap);
  // From the front, feet find the ground.
  const landed = editor.isUpright ? nearestMove([box.min[1]], [0], by[1], metersOf(REACH, editor)) : null;
  const to: Point = [guided.isHeld[0] ? guided.by[0] : free[0], guided.isHeld[1] ? guided.by[1] : (landed ?? free[1])];
  return { command: moveAgents(keyframe, agents, to), guides: guided.guides };
}
