import { groupWithSet } from "../group-with-set";
import type { Command } from "../store";
import { makeGroup, setGroupTieWeight } from "./groups";

/** Tie agents together by a factor: the group of exactly these agents gets it, and is made where there is none. */
export function tieAgents(agents: ReadonlySet<number>, factor: number): Command {
  return {
    label: `Tie ×${factor}`,
    apply: (scene) => {
      const grouped = makeGroup(agents).apply(scene);
      const path = groupWithSet(grouped.groups, agents);
      return path ? setGroupTieWeight(path, factor).apply(grouped) : scene;
    },
  };
}
