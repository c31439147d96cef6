import type { Formation } from "../../document/formation";

/** The straight ways of everybody, meters. */
export interface Walks {
  readonly total: number;
  readonly longest: number;
  /** Whose is the longest; −1 of nobody. */
  readonly who: number;
}

/** @param slots by agent, the place it takes; absent: its own */
export function walksOf(from: Formation, to: Formation, slots?: readonly number[]): Walks {
  let [total, longest, who] = [0, 0, -1];
  for (let agent = 0; agent < from.agentCount; agent += 1) {
    const slot = slots?.[agent] ?? agent;
    const rise = to.height(slot) - from.height(agent);
    const way = Math.hypot(to.x(slot) - from.x(agent), to.y(slot) - from.y(agent), rise);
    total += way;
    if (way > longest || who < 0) [longest, who] = [way, agent];
  }
  return { total, longest, who };
}

/** The agent or place nearest to a point in plan, within a reach; null when none is. */
export function nearestTo([x, y]: readonly [x: number, y: number], formation: Formation, reach: number): number | null {
  let [nearest, least]: [number | null, number] = [null, reach];
  for (let agent = 0; agent < formation.agentCount; agent += 1) {
    const away = Math.hypot(formation.x(agent) - x, formation.y(agent) - y);
    if (away <= least) [nearest, least] = [agent, away];
  }
  return nearest;
}
