import type { Formation, Point } from "../../document/formation";
import type { Bends } from "../../engine/api";

/** The ways of everybody, meters: straight, or as they bend around obstacles. */
export interface Walks {
  readonly total: number;
  readonly longest: number;
  /** Whose is the longest; −1 of nobody. */
  readonly who: number;
}

/**
 * @param bends by agent, where its way bends
 * @param slots by agent, the place it takes; absent: its own
 */
export function walksOf(from: Formation, to: Formation, bends?: Bends, slots?: readonly number[]): Walks {
  let [total, longest, who] = [0, 0, -1];
  for (let agent = 0; agent < from.agentCount; agent += 1) {
    const slot = slots?.[agent] ?? agent;
    const rise = to.height(slot) - from.height(agent);
    const way = Math.hypot(lengthOf([from.point(agent), ...(bends?.[agent] ?? []), to.point(slot)]), rise);
    total += way;
    if (way > longest || who < 0) [longest, who] = [way, agent];
  }
  return { total, longest, who };
}

function lengthOf(places: readonly Point[]): number {
  let length = 0;
  for (let k = 1; k < places.length; k += 1) {
    const [from, to] = [places[k - 1] ?? [0, 0], places[k] ?? [0, 0]];
    length += Math.hypot(to[0] - from[0], to[1] - from[1]);
  }
  return length;
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

/** A target and the ways to it once it is known who takes which place: who stays is where it was, at the place of an absent agent. */
export function withStays(
  from: Formation,
  to: Formation,
  absent: readonly number[],
  { slots, bends }: { readonly slots: readonly number[]; readonly bends: Bends },
): { readonly to: Formation; readonly bends: Bends } {
  const isStaying = (agent: number) => absent.includes(slots[agent] ?? -1);
  const stays = slots.flatMap((slot, agent) => (isStaying(agent) ? [[slot, from.point(agent)] as const] : []));
  return { to: to.with(stays), bends: bends.map((way, agent) => (isStaying(agent) ? [] : way)) };
}
