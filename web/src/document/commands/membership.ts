import { groupOf, groupPaths } from "../groups";
import { groupLabel } from "../queries";
import type { GroupPath, Scene } from "../scene";
import type { Command } from "../store";
import { addToGroup, removeFromGroup } from "./groups";

/** A group to be in, or none, with a key that a list can hold. */
export interface Membership {
  readonly key: string;
  /** With the groups around it: `Band / Brass`. */
  readonly label: string;
  readonly path: GroupPath | null;
}

/** None first, then every group, parents before children. */
export function memberships(scene: Scene): readonly Membership[] {
  const groups = groupPaths(scene.groups).map((path) => ({
    key: keyOf(path),
    label: path.map((_, depth) => groupLabel(scene, path.slice(0, depth + 1))).join(" / "),
    path,
  }));
  return [{ key: keyOf(null), label: "None", path: null }, ...groups];
}

/** The key of the innermost group an agent is in. */
export function membershipOf(scene: Scene, agent: number): string {
  return keyOf(groupOf(scene.groups, agent));
}

/** Agents join a group, or leave all groups. */
export function moveToGroup(path: GroupPath | null, agents: ReadonlySet<number>): Command {
  if (path) return addToGroup(path, agents);
  return {
    label: "Remove from group",
    apply: (scene) => {
      let left = scene;
      // Backwards: a group that is left empty goes, and those after it move up.
      for (let top = scene.groups.length - 1; top >= 0; top -= 1) left = removeFromGroup([top], agents).apply(left);
      return left;
    },
  };
}

function keyOf(path: GroupPath | null): string {
  return path ? path.join(".") : "none";
}
