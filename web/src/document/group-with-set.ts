import { groupAt, groupPaths, groupSet } from "./groups";
import type { Group, GroupPath } from "./scene";
import { areSame } from "./sets";

/** The outermost group of exactly these agents; null when there is none. */
export function groupWithSet(groups: readonly Group[], agents: ReadonlySet<number>): GroupPath | null {
  const isIt = (path: GroupPath) => {
    const group = groupAt(groups, path);
    return group !== undefined && areSame(groupSet(group), agents);
  };
  return groupPaths(groups).find(isIt) ?? null;
}
