import { groupAt, groupPaths, groupSet } from "../../document/groups";
import { groupColor, groupLabel } from "../../document/queries";
import { type GroupPath, mainTrack, type Scene } from "../../document/scene";

/** A line of the table: a group with everybody in it counted, or one agent. */
export type TableRow =
  | {
      readonly kind: "heading";
      /** Null for the agents in no group. */
      readonly path: GroupPath | null;
      readonly label: string;
      readonly color: string;
      readonly agentCount: number;
      /** Factor of the ties inside; null for none. */
      readonly tieWeight: number | null;
    }
  | { readonly kind: "agent"; readonly agent: number; readonly path: GroupPath | null };

/** Every agent once: group by group, parents first, then those in none; without groups there are no headings. */
export function tableRows(scene: Scene): TableRow[] {
  const count = mainTrack(scene).agents.length;
  const rest = new Set(Array.from({ length: count }, (_, agent) => agent));
  const rows: TableRow[] = [];
  for (const path of groupPaths(scene.groups)) {
    const group = groupAt(scene.groups, path);
    if (!group) continue;
    rows.push({
      kind: "heading",
      path,
      label: groupLabel(scene, path),
      color: groupColor(scene, path),
      agentCount: groupSet(group).size,
      tieWeight: group.tieWeight,
    });
    for (const agent of [...group.members].sort((a, b) => a - b)) {
      if (rest.delete(agent)) rows.push({ kind: "agent", agent, path });
    }
  }
  if (rest.size > 0 && rows.length > 0) {
    rows.push({ kind: "heading", path: null, label: "No group", color: "", agentCount: rest.size, tieWeight: null });
  }
  for (const agent of rest) rows.push({ kind: "agent", agent, path: null });
  return rows;
}
