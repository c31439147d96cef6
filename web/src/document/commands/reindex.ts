import type { AdjacencySpec, Group, GroupPath, Segment } from "../scene";

/** Groups of the agents that stay, under their new indices; a group that loses its last agent goes. */
export function dropFromGroups(groups: readonly Group[], places: ReadonlyMap<number, number>): readonly Group[] {
  return groups.flatMap((group) => {
    const members = group.members.flatMap((member) => places.get(member) ?? []);
    const children = dropFromGroups(group.children, places);
    const isEmptied = members.length === 0 && children.length === 0;
    const wasEmpty = group.members.length === 0 && group.children.length === 0;
    return isEmptied && !wasEmpty ? [] : [{ ...group, members, children }];
  });
}

/** Where a group is once others are dropped; null when it goes itself. */
export function pathAfterDrop(
  groups: readonly Group[],
  places: ReadonlyMap<number, number>,
  path: GroupPath,
): GroupPath | null {
  const [step, ...rest] = path;
  if (step === undefined) return [];
  const group = groups[step];
  if (!group || dropFromGroups([group], places).length === 0) return null;
  const within = pathAfterDrop(group.children, places, rest);
  return within && [dropFromGroups(groups.slice(0, step), places).length, ...within];
}

/** Ties among the agents that stay, under their new indices. */
export function dropFromAdjacency(adjacency: AdjacencySpec, places: ReadonlyMap<number, number>): AdjacencySpec {
  return {
    ...adjacency,
    ties: adjacency.ties.flatMap(([a, b, factor]) => {
      const [p, q] = [places.get(a), places.get(b)];
      return p === undefined || q === undefined ? [] : [[p, q, factor] as const];
    }),
    cuts: adjacency.cuts.flatMap(([a, b]) => {
      const [p, q] = [places.get(a), places.get(b)];
      return p === undefined || q === undefined ? [] : [[p, q] as const];
    }),
    obstacleTies: adjacency.obstacleTies.flatMap(([agent, obstacle, factor]) => {
      const place = places.get(agent);
      return place === undefined ? [] : [[place, obstacle, factor] as const];
    }),
  };
}

/** A transition whose locks are those of the agents that stay, under their new indices. */
export function dropFromLocks(segment: Segment, places: ReadonlyMap<number, number>): Segment {
  const { assignment } = segment;
  if (!assignment || assignment.locks.length === 0) return segment;
  const locks = assignment.locks.flatMap(([agent, slot]) => {
    const [p, q] = [places.get(agent), places.get(slot)];
    return p === undefined || q === undefined ? [] : [[p, q] as const];
  });
  return { ...segment, assignment: { ...assignment, locks } };
}
