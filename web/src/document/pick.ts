import { groupAt, groupOf, groupSet } from "./groups";
import type { Group, GroupPath, Scene } from "./scene";
import { NOTHING, type Selection } from "./selection";
import { areSame, isWithin } from "./sets";

/**
 * Groups are taken as one: a click picks the outermost group, a double click goes a step inside, and from inside a click
 * picks among those beside what is selected.
 */

/** What a click on an agent picks, given what is selected: a group, or the agent by itself. */
export function picked(scene: Scene, selection: Selection, agent: number): Selection {
  const home = groupOf(scene.groups, agent) ?? [];
  return below(home, shared(home, scopeOf(scene.groups, selection)), agent);
}

/** What a double click on an agent picks: one step further inside than what is selected. */
export function pickedInside(scene: Scene, selection: Selection, agent: number): Selection {
  const home = groupOf(scene.groups, agent) ?? [];
  const at = selection.kind === "group" ? selection.path : scopeOf(scene.groups, selection);
  return below(home, shared(home, at), agent);
}

/** What is selected after stepping out: the group around, or nothing. */
export function outside(scene: Scene, selection: Selection): Selection {
  const around = scopeOf(scene.groups, selection);
  return around.length > 0 ? { kind: "group", path: around } : NOTHING;
}

/** The group that the person is inside of; empty at the top. */
function scopeOf(groups: readonly Group[], selection: Selection): GroupPath {
  if (selection.kind === "group") return selection.path.slice(0, -1);
  if (selection.kind !== "agents" || selection.agents.size === 0) return [];
  const holder = innermostHolder(groups, selection.agents);
  const group = groupAt(groups, holder);
  return group && areSame(groupSet(group), selection.agents) ? holder.slice(0, -1) : holder;
}

/** The innermost group that holds all of some agents; empty when none does. */
export function innermostHolder(
  groups: readonly Group[],
  agents: ReadonlySet<number>,
  path: GroupPath = [],
): GroupPath {
  const index = groups.findIndex((group) => isWithin(agents, groupSet(group)));
  const group = groups[index];
  return group ? innermostHolder(group.children, agents, [...path, index]) : path;
}

function below(home: GroupPath, depth: number, agent: number): Selection {
  if (home.length > depth) return { kind: "group", path: home.slice(0, depth + 1) };
  return { kind: "agents", agents: new Set([agent]) };
}

/** How many steps two paths have in common. */
function shared(one: GroupPath, other: GroupPath): number {
  const parting = one.findIndex((step, depth) => step !== other[depth]);
  return parting < 0 ? one.length : parting;
}
