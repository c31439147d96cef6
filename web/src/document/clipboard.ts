import { addAgents, placeAgents } from "./commands/agents";
import type { Formation, Point } from "./formation";
import { placementAt } from "./placement";
import { agentLabel } from "./queries";
import { mainTrack, type Scene } from "./scene";
import type { Selection } from "./selection";
import type { Command } from "./store";

/** Agents as other programs paste them: a line each with name or number, x and y in meters, parted by tabs. */
export function agentsAsText(scene: Scene, keyframe: number, agents: ReadonlySet<number>): string {
  const positions = mainTrack(scene).keyframes[keyframe]?.positions;
  if (!positions) return "";
  return [...agents]
    .sort((a, b) => a - b)
    .map((agent) => {
      const label = agentLabel(scene, agent).replace(/\s+/g, " ");
      return `${label}\t${positions.x(agent)}\t${positions.y(agent)}`;
    })
    .join("\n");
}

/**
 * Pasted lines as a keyframe CSV of one keyframe, for the engine to read.
 *
 * Cells are carried over as text and quoted: whether they are numbers, and which are admissible, is decided by the one
 * door that all files come through. Null when the text is no table of two (x, y) or three columns.
 */
export function textAsKeyframes(text: string): string | null {
  const lines = text.split(/\r?\n/).filter((line) => line.trim() !== "");
  const rows = lines.map((line) => line.split("\t").map((cell) => cell.trim()));
  if (rows.length === 0 || rows.some((cells) => cells.length !== 2 && cells.length !== 3)) return null;
  const body = rows.map((cells, row) => {
    const [name, x, y] = cells.length === 3 ? cells : ["", ...cells];
    return ["0", "0", String(row + 1), "", quoted(name), quoted(x), quoted(y)].join(",");
  });
  return ["keyframe,time,agent,group,name,x,y", ...body, ""].join("\n");
}

export type Pasting =
  | { readonly kind: "command"; readonly command: Command; readonly agents: readonly number[] }
  | { readonly kind: "refused"; readonly reason: string };

/**
 * What pasting does at a keyframe: at the first, new agents; at later ones the agents that are named there, or else the
 * selected ones in order, take the pasted places.
 */
export function pasteAt(scene: Scene, keyframe: number, selection: Selection, pasted: Scene): Pasting {
  const names = mainTrack(pasted).agents.map((agent) => agent.name);
  const places = mainTrack(pasted).keyframes[0]?.positions.points() ?? [];
  const placement = placementAt(scene, keyframe, selection);
  if (placement.kind === "add") return pasteNew(scene, names, places);
  const named = agentsNamed(scene, names);
  const agents = named ?? placement.agents;
  if (agents.length !== places.length) {
    const reason = `${places.length} places were copied for ${agents.length} agents. ${placement.reason}`;
    return { kind: "refused", reason };
  }
  const order = Uint32Array.from(agents.keys());
  return { kind: "command", command: placeAgents(keyframe, agents, places, order, "Paste places"), agents };
}

function pasteNew(scene: Scene, names: readonly string[], places: readonly Point[]): Pasting {
  const first = mainTrack(scene).agents.length;
  const positions = mainTrack(scene).keyframes[0]?.positions;
  const by = positions && places.some((place) => isTaken(positions, place)) ? 1 : 0;
  const shifted = places.map(([x, y]): Point => [x + by, y - by]);
  // A number is what an agent without a name is called, not its name.
  const agents = names.map((name) => ({ name: /^\d*$/.test(name) ? "" : name }));
  const command = addAgents(shifted, "Paste agents", agents);
  return { kind: "command", command, agents: Array.from(places, (_, i) => first + i) };
}

function agentsNamed(scene: Scene, names: readonly string[]): number[] | null {
  const byLabel = new Map(mainTrack(scene).agents.map((_, agent) => [agentLabel(scene, agent), agent]));
  const found = names.flatMap((name) => byLabel.get(name) ?? []);
  return found.length === names.length && new Set(found).size === found.length ? found : null;
}

function isTaken(positions: Formation, [x, y]: Point): boolean {
  return positions.points().some(([px, py]) => px === x && py === y);
}

function quoted(cell: string | undefined): string {
  return `"${(cell ?? "").replaceAll('"', '""')}"`;
}
