import type { Line } from "./line-sample";
import { COSTS, type CostWord, type RunChoice, WAYS, type WayWord } from "./run-words";

/** One way under one cost, and how its curves look. */
export interface RunRow {
  readonly way: WayWord;
  readonly cost: CostWord;
  readonly line: Line;
}

/** Every way under every cost, cost by cost. A color a way; of one way alone a color a cost. */
export function rowsOf({ ways, costs }: RunChoice): readonly RunRow[] {
  const chosen = WAYS.filter(({ way }) => ways.includes(way));
  return COSTS.filter(({ cost }) => costs.includes(cost)).flatMap((cost) =>
    chosen.map((way): RunRow => {
      const isAlone = chosen.length === 1;
      const dash = costs.length > 1 ? cost.dash : [];
      return { way, cost, line: { color: isAlone && costs.length > 1 ? cost.color : way.color, dash } };
    }),
  );
}
