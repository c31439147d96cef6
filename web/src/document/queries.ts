import { groupAt, groupOf, groupPaths, groupSet } from "./groups";
import { GROUP_COLORS, UNGROUPED_COLOR } from "./palette";
import { type GroupPath, mainTrack, type Scene } from "./scene";
import type { Selection } from "./selection";

/** What a person calls an agent: its name, or its number from 1. */
export function agentLabel(scene: Scene, agent: number): string {
  return mainTrack(scene).agents[agent]?.name || String(agent + 1);
}

export function keyframeLabel(scene: Scene, keyframe: number): string {
  return mainTrack(scene).keyframes[keyframe]?.name || `Keyframe ${keyframe + 1}`;
}

export function groupLabel(scene: Scene, path: GroupPath): string {
  return groupAt(scene.groups, path)?.name || `Group ${path.map((step) => step + 1).join(".")}`;
}

/** As stored: `#rrggbb`; a group without one has the next of the palette. */
export function groupColor(scene: Scene, path: GroupPath): string {
  const own = groupAt(scene.groups, path)?.color;
  if (own) return own;
  const place = groupPaths(scene.groups).findIndex((other) => other.join() === path.join());
  return GROUP_COLORS[Math.max(0, place) % GROUP_COLORS.length] ?? UNGROUPED_COLOR;
}

/** As stored: `#rrggbb`; an agent without one has its group's. */
export function agentColor(scene: Scene, agent: number): string {
  const own = mainTrack(scene).agents[agent]?.color;
  if (own) return own;
  const path = groupOf(scene.groups, agent);
  return path ? groupColor(scene, path) : UNGROUPED_COLOR;
}

/** The color of every agent, by agent index; one pass over the groups. */
export function agentColors(scene: Scene): readonly string[] {
  const colors = mainTrack(scene).agents.map((agent) => agent.color);
  groupPaths(scene.groups).forEach((path, place) => {
    const group = groupAt(scene.groups, path);
    const color = group?.color || (GROUP_COLORS[place % GROUP_COLORS.length] ?? UNGROUPED_COLOR);
    for (const member of group?.members ?? []) colors[member] ||= color;
  });
  return colors.map((color) => color || UNGROUPED_COLOR);
}

const NOBODY: ReadonlySet<number> = new Set();

/** The agents a selection stands for: its own, a group's set, the two of a tie. */
export function selectedAgents(scene: Scene, selection: Selection): ReadonlySet<number> {
  switch (selection.kind) {
    case "agents":
      return selection.agents;
    case "group": {
      const group = groupAt(scene.groups, selection.path);
      return group ? groupSet(group) : NOBODY;
    }
    case "tie":
      return new Set([selection.a, selection.b]);
    default:
      return NOBODY;
  }
}

export function allAgents(scene: Scene): ReadonlySet<number> {
  return new Set(mainTrack(scene).agents.keys());
}

/** Whether agents move and no distance is asked of them, so that nobody is warned of a meeting. */
export function isWithoutDistance(scene: Scene): boolean {
  return scene.minimumDistance === 0 && mainTrack(scene).segments.length > 0;
}
