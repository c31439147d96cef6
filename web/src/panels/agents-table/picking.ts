import type { Selection } from "../../document/selection";
import { toggled } from "../../document/sets";
import type { TableRow } from "./table-rows";

/** How a row joins what is selected: alone, with those already, or with all between. */
export type Picking = "only" | "toggle" | "range";

/** The selection after a row is picked. `anchor` is the row that a range starts from. */
export function pick(
  rows: readonly TableRow[],
  selected: ReadonlySet<number>,
  index: number,
  anchor: number,
  picking: Picking,
): Selection {
  const row = rows[index];
  if (!row) return { kind: "none" };
  if (row.kind === "heading") {
    return row.path ? { kind: "group", path: row.path } : agentsSelection(agentsUnder(rows, index));
  }
  switch (picking) {
    case "only":
      return agentsSelection(new Set([row.agent]));
    case "toggle":
      return agentsSelection(toggled(selected, new Set([row.agent])));
    case "range": {
      const between = rows.slice(Math.min(anchor, index), Math.max(anchor, index) + 1);
      return agentsSelection(new Set(between.flatMap((other) => (other.kind === "agent" ? [other.agent] : []))));
    }
  }
}

/** The agents below a heading, up to the next. */
function agentsUnder(rows: readonly TableRow[], heading: number): Set<number> {
  const agents = new Set<number>();
  for (let index = heading + 1; index < rows.length; index += 1) {
    const row = rows[index];
    if (row?.kind !== "agent") break;
    agents.add(row.agent);
  }
  return agents;
}

function agentsSelection(agents: ReadonlySet<number>): Selection {
  return agents.size > 0 ? { kind: "agents", agents } : { kind: "none" };
}
