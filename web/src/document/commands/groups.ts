import { chooseAllAgain } from "../edit";
import { groupWithSet } from "../group-with-set";
import { groupAt, groupPaths, groupSet } from "../groups";
import { clipText, LIMITS, withinLimits } from "../limits";
import { GROUP_COLORS } from "../palette";
import { innermostHolder } from "../pick";
import { type Group, type GroupPath, mainTrack, type Scene } from "../scene";
import { common, isWithin, without } from "../sets";
import type { Command } from "../store";
import { changeChildren, changeGroup, removeGroup, withoutAgents } from "./group-tree";
import { followNodes } from "./nodes";

/**
 * Make a group of agents, inside the innermost group that holds them all.
 *
 * Groups that lie wholly within become its children; the other agents leave the groups they were in.
 */
export function makeGroup(agents: ReadonlySet<number>, name?: string): Command {
  return {
    label: "Make group",
    apply: (scene) => {
      const known = new Set([...agents].filter((agent) => mainTrack(scene).agents[agent]));
      if (known.size === 0 || groupWithSet(scene.groups, known)) return scene;
      const holder = innermostHolder(scene.groups, known);
      const siblings = groupAt(scene.groups, holder)?.children ?? scene.groups;
      const children = siblings.filter((group) => isWithin(groupSet(group), known));
      const nested = new Set(children.flatMap((group) => [...groupSet(group)]));
      const members = [...without(known, nested)].sort((a, b) => a - b);
      const group: Group = {
        name: clipText(name?.trim() || freeName(scene.groups), LIMITS.name),
        color: freeColor(scene.groups),
        members,
        tieWeight: null,
        children,
      };
      const left = withoutAgents(scene.groups, new Set(members));
      return withGroups(
        scene,
        changeChildren(left, holder, (list) => [...list.filter((other) => !children.includes(other)), group]),
      );
    },
  };
}

export function renameGroup(path: GroupPath, name: string): Command {
  return { label: "Rename group", apply: (scene) => patch(scene, path, { name: clipText(name.trim(), LIMITS.name) }) };
}

/** @param color `#rrggbb`, or empty for the next of the palette */
export function colorGroup(path: GroupPath, color: string): Command {
  return { label: "Color group", apply: (scene) => patch(scene, path, { color }) };
}

/** @param factor of the ties among its set; null: no ties of its own */
export function setGroupTieWeight(path: GroupPath, factor: number | null): Command {
  return {
    label: "Change group ties",
    apply: (scene) => {
      const { min, max } = LIMITS.factor;
      const isSound = factor === null || (factor >= min && factor <= max);
      return isSound ? patch(scene, path, { tieWeight: factor }) : scene;
    },
  };
}

/** Put a group inside another; an empty path brings it to the top. */
export function nestGroup(path: GroupPath, into: GroupPath): Command {
  return {
    label: into.length > 0 ? "Nest group" : "Unnest group",
    apply: (scene) => {
      const group = groupAt(scene.groups, path);
      const isInside = path.every((step, i) => into[i] === step);
      const isThere = into.length === path.length - 1 && into.every((step, i) => path[i] === step);
      if (!group || isInside || isThere || (into.length > 0 && !groupAt(scene.groups, into))) return scene;
      // Appended first: the paths of those already there do not move.
      const appended = changeChildren(scene.groups, into, (list) => [...list, group]);
      return withGroups(scene, removeGroup(appended, path));
    },
  };
}

/** A group's agents and children belong to its parent again. */
export function dissolveGroup(path: GroupPath): Command {
  return {
    label: "Dissolve group",
    apply: (scene) => {
      const group = groupAt(scene.groups, path);
      const index = path.at(-1);
      if (!group || index === undefined) return scene;
      const parent = path.slice(0, -1);
      const lifted = changeChildren(scene.groups, parent, (list) => list.toSpliced(index, 1, ...group.children));
      return withGroups(
        scene,
        changeGroup(lifted, parent, (holder) => ({ ...holder, members: [...holder.members, ...group.members] })),
      );
    },
  };
}

/** Agents join a group and leave the one they were in. */
export function addToGroup(path: GroupPath, agents: ReadonlySet<number>): Command {
  return {
    label: "Add to group",
    apply: (scene) => {
      const group = groupAt(scene.groups, path);
      if (!group) return scene;
      const known = [...agents].filter((agent) => mainTrack(scene).agents[agent]);
      return withGroups(scene, join(scene.groups, path, without(new Set(known), groupSet(group))));
    },
  };
}

/** Agents leave a group for its parent. */
export function removeFromGroup(path: GroupPath, agents: ReadonlySet<number>): Command {
  return {
    label: "Remove from group",
    apply: (scene) => {
      const group = groupAt(scene.groups, path);
      if (!group) return scene;
      const leaving = common(agents, groupSet(group));
      const parent = path.slice(0, -1);
      const isTop = parent.length === 0;
      return withGroups(scene, isTop ? withoutAgents(scene.groups, leaving) : join(scene.groups, parent, leaving));
    },
  };
}

function join(groups: readonly Group[], path: GroupPath, agents: ReadonlySet<number>): readonly Group[] {
  if (agents.size === 0) return groups;
  const joined = changeGroup(groups, path, (group) => ({
    ...group,
    members: [...new Set([...group.members, ...agents])],
  }));
  return withoutAgents(joined, agents, groupAt(joined, path));
}

function patch(scene: Scene, path: GroupPath, change: Partial<Group>): Scene {
  return withGroups(
    scene,
    changeGroup(scene.groups, path, (group) => {
      const isSame = Object.entries(change).every(([key, value]) => group[key as keyof Group] === value);
      return isSame ? group : { ...group, ...change };
    }),
  );
}

/** Groups matter to a motion through their ties, and where it goes by groups: then auto chooses again. */
export function withGroups(scene: Scene, groups: readonly Group[]): Scene {
  if (groups === scene.groups) return scene;
  const next = followNodes(scene, { ...scene, groups });
  const isTied = [scene.groups, groups].some((tree) =>
    groupPaths(tree).some((path) => groupAt(tree, path)?.tieWeight != null),
  );
  const isMoving = mainTrack(scene).segments.some((segment) => segment.hierarchy);
  return withinLimits(scene, isTied || isMoving ? chooseAllAgain(next) : next);
}

function freeName(groups: readonly Group[]): string {
  const names = new Set(groupPaths(groups).map((path) => groupAt(groups, path)?.name));
  let number = 1;
  while (names.has(`Group ${number}`)) number += 1;
  return `Group ${number}`;
}

/** The first color no group has; when all are taken, they go around again. */
function freeColor(groups: readonly Group[]): string {
  const paths = groupPaths(groups);
  const taken = new Set(paths.map((path, i) => groupAt(groups, path)?.color || GROUP_COLORS[i % GROUP_COLORS.length]));
  return GROUP_COLORS.find((color) => !taken.has(color)) ?? GROUP_COLORS[paths.length % GROUP_COLORS.length] ?? "";
}
