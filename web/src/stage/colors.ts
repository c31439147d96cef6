import type { Group, Scene } from "../document/scene";
import { mainTrack } from "../document/scene";

/** Agent colors as the scene stores them: the light values of `--agent-1` … `--agent-10`. */
export const AGENT_COLORS: readonly string[] = [
  "#c64f36",
  "#2d48cc",
  "#b98800",
  "#024b3b",
  "#e85fa8",
  "#1399e4",
  "#620687",
  "#07875b",
  "#4c5600",
  "#1d2a3a",
];

/** The last of the palette is kept for agents without a group. */
const UNGROUPED = AGENT_COLORS[AGENT_COLORS.length - 1] ?? "";
const GROUP_COLORS = AGENT_COLORS.slice(0, -1);

/** A group of the tree with the color it is shown in and everybody in it. */
export interface ColoredGroup {
  readonly group: Group;
  /** Child indices from the root. */
  readonly path: readonly number[];
  /** As stored, `#rrggbb`. */
  readonly color: string;
  /** Its members and its children's, by rising index. */
  readonly agents: readonly number[];
}

/** Every group, parents before children; one without a color takes that of its place in this order: 1, 2, 3 … */
export function coloredGroups(groups: readonly Group[]): ColoredGroup[] {
  const found: ColoredGroup[] = [];
  function visit(siblings: readonly Group[], parent: readonly number[]): void {
    siblings.forEach((group, child) => {
      const path = [...parent, child];
      const color = group.color || (GROUP_COLORS[found.length % GROUP_COLORS.length] ?? UNGROUPED);
      found.push({ group, path, color, agents: [...membersOf(group)].sort((a, b) => a - b) });
      visit(group.children, path);
    });
  }
  visit(groups, []);
  return found;
}

/** The stored color each agent shows: its own, else its innermost group's, else that of the ungrouped. */
export function agentColors(scene: Scene): string[] {
  const { agents, keyframes } = mainTrack(scene);
  const count = keyframes[0]?.positions.agentCount ?? agents.length;
  const colors = new Array<string>(count).fill(UNGROUPED);
  // Parents come first, so the innermost group speaks last.
  for (const { color, agents: members } of coloredGroups(scene.groups)) {
    for (const agent of members) if (agent < count) colors[agent] = color;
  }
  agents.forEach((agent, index) => {
    if (agent.color && index < count) colors[index] = agent.color;
  });
  return colors;
}

/** 1 to 10 for a palette color, null for one of the person's own. */
export function paletteNumber(color: string): number | null {
  const index = AGENT_COLORS.indexOf(color.toLowerCase());
  return index < 0 ? null : index + 1;
}

function membersOf(group: Group): Set<number> {
  const all = new Set(group.members);
  for (const child of group.children) for (const agent of membersOf(child)) all.add(agent);
  return all;
}
