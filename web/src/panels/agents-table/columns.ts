import { renameAgent, setPlace } from "../../document/commands/agents";
import { clampCoordinate } from "../../document/limits";
import { parseLength } from "../../document/parse";
import { agentLabel } from "../../document/queries";
import type { Scene } from "../../document/scene";
import type { Command } from "../../document/store";
import { formatLength } from "../../document/units";

export type ColumnName = "name" | "group" | "x" | "y";

export const COLUMNS: readonly ColumnName[] = ["name", "group", "x", "y"];

/** What a cell reads before it is edited. */
export function cellText(scene: Scene, xy: ArrayLike<number>, agent: number, column: ColumnName): string {
  switch (column) {
    case "name":
      return agentLabel(scene, agent);
    case "group":
      return "";
    case "x":
      return coordinateText(scene, xy[2 * agent]);
    case "y":
      return coordinateText(scene, xy[2 * agent + 1]);
  }
}

/** Whether a cell can take a text over. */
export function accepts(scene: Scene, column: ColumnName, text: string): boolean {
  if (column === "name") return true;
  const length = parseLength(text, scene.stage.units);
  return length !== null && length === clampCoordinate(length);
}

/** What typing `text` into a cell does; null when it does nothing. */
export function cellCommand(
  scene: Scene,
  xy: ArrayLike<number>,
  cell: { readonly agent: number; readonly column: ColumnName; readonly keyframe: number },
  text: string,
): Command | null {
  const { agent, column, keyframe } = cell;
  if (text === cellText(scene, xy, agent, column)) return null;
  if (column === "name") return renameAgent(agent, text);
  const length = parseLength(text, scene.stage.units);
  const x = xy[2 * agent];
  const y = xy[2 * agent + 1];
  if (length === null || x === undefined || y === undefined) return null;
  return setPlace(keyframe, agent, column === "x" ? [length, y] : [x, length]);
}

function coordinateText(scene: Scene, meters: number | undefined): string {
  return meters === undefined ? "" : formatLength(meters, scene.stage.units);
}
