import { groupAt, groupSet } from "../groups";
import type { Group, GroupPath } from "../scene";
import { isWithin, without } from "../sets";
import type { Command } from "../store";
import { changeGroup, withoutAgents } from "./group-tree";
import { withGroups } from "./groups";

/** A proposed group: agents of its own and groups within. */
export interface Branch {
  readonly members: readonly number[];
  readonly children: readonly Branch[];
}

/**
 * Groups as proposed, in place of those that their agents were in.
 *
 * @param inside the group that is divided; empty: they come to the top
 */
export function takeProposal(inside: GroupPath, branches: readonly Branch[]): Command {
  return {
    label: "Propose groups",
    apply: (scene) => {
      const groups = branches.map(groupFrom);
      const agents = new Set(groups.flatMap((group) => [...groupSet(group)]));
      const host = groupAt(scene.groups, inside);
      if (agents.size === 0) return scene;
      if (!host) return withGroups(scene, [...withoutAgents(scene.groups, agents), ...groups]);
      const all = groupSet(host);
      if (!isWithin(agents, all)) return scene;
      const members = [...without(all, agents)].sort((a, b) => a - b);
      return withGroups(
        scene,
        changeGroup(scene.groups, inside, (group) => ({ ...group, members, children: groups })),
      );
    },
  };
}

/** Without a name or color of its own it is shown by number, in the next color. */
function groupFrom({ members, children }: Branch): Group {
  return { name: "", color: "", members, tieWeight: null, children: children.map(groupFrom) };
}
