import { groupAt } from "../groups";
import type { Group, GroupPath } from "../scene";

type Groups = readonly Group[];

/** The tree with the list of groups at `parent` (the root: an empty path) changed. */
export function changeChildren(groups: Groups, parent: GroupPath, change: (children: Groups) => Groups): Groups {
  const [first, ...rest] = parent;
  if (first === undefined) return change(groups);
  return changeGroup(groups, [first], (group) => ({
    ...group,
    children: changeChildren(group.children, rest, change),
  }));
}

/** The tree with one group changed; the same tree when it is. */
export function changeGroup(groups: Groups, path: GroupPath, change: (group: Group) => Group): Groups {
  const [index, ...rest] = path;
  const group = index === undefined ? undefined : groups[index];
  if (index === undefined || !group) return groups;
  if (rest.length > 0) {
    const children = changeGroup(group.children, rest, change);
    return children === group.children ? groups : groups.with(index, { ...group, children });
  }
  const next = change(group);
  return next === group ? groups : groups.with(index, next);
}

/** The tree without a group and all within it; a parent left empty goes too. */
export function removeGroup(groups: Groups, path: GroupPath): Groups {
  const removed = changeChildren(groups, path.slice(0, -1), (list) => list.filter((_, i) => i !== path.at(-1)));
  const parent = path.slice(0, -1);
  const left = groupAt(removed, parent);
  return left && left.members.length === 0 && left.children.length === 0 ? removeGroup(removed, parent) : removed;
}

/** The tree in which some agents are members of `keep` at most; a group that loses its last agent goes. */
export function withoutAgents(groups: Groups, gone: ReadonlySet<number>, keep?: Group): Groups {
  const next = groups.flatMap((group) => {
    const members = group === keep ? group.members : group.members.filter((member) => !gone.has(member));
    const children = withoutAgents(group.children, gone, keep);
    const isSame = members.length === group.members.length && children === group.children;
    if (isSame) return [group];
    return members.length === 0 && children.length === 0 ? [] : [{ ...group, members, children }];
  });
  return next.length === groups.length && next.every((group, i) => group === groups[i]) ? groups : next;
}
