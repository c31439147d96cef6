import type { Group, GroupPath } from "./scene";

/** The group at a path; undefined when there is none. */
export function groupAt(groups: readonly Group[], path: GroupPath): Group | undefined {
  let level = groups;
  let group: Group | undefined;
  for (const index of path) {
    group = level[index];
    if (!group) return undefined;
    level = group.children;
  }
  return group;
}

/** Every group's path, parents before children. */
export function groupPaths(groups: readonly Group[], parent: GroupPath = []): GroupPath[] {
  return groups.flatMap((group, index) => {
    const path = [...parent, index];
    return [path, ...groupPaths(group.children, path)];
  });
}

/** A group's set: its members and its children's sets. */
export function groupSet(group: Group): ReadonlySet<number> {
  const set = new Set(group.members);
  for (const child of group.children) for (const agent of groupSet(child)) set.add(agent);
  return set;
}

/** The innermost group of an agent; null when it is in none. */
export function groupOf(groups: readonly Group[], agent: number): GroupPath | null {
  for (const [index, group] of groups.entries()) {
    const inner = groupOf(group.children, agent);
    if (inner) return [index, ...inner];
    if (group.members.includes(agent)) return [index];
  }
  return null;
}

/** The innermost group of every agent, by agent index. */
export function groupOfAgents(groups: readonly Group[], agentCount: number): readonly (GroupPath | null)[] {
  const paths: (GroupPath | null)[] = Array.from({ length: agentCount }, () => null);
  for (const path of groupPaths(groups)) {
    for (const agent of groupAt(groups, path)?.members ?? []) paths[agent] = path;
  }
  return paths;
}

/** How deep the tree is: 0 without groups. */
export function groupDepth(groups: readonly Group[]): number {
  return groups.reduce((depth, group) => Math.max(depth, 1 + groupDepth(group.children)), 0);
}
