import type { Formation, Point } from "../../document/formation";
import type { ModeBasis } from "../../engine/modes";

/** What each mode contributes to a formation: the (α, β) of the paper's equation 1, meters, by mode. */
export function coefficientsOf(basis: ModeBasis, formation: Formation): Point[] {
  return Array.from({ length: basis.shownCount }, (_, index): Point => {
    const mode = basis.mode(index);
    let [alpha, beta] = [0, 0];
    for (let agent = 0; agent < basis.agentCount; agent += 1) {
      const entry = mode[agent] ?? 0;
      alpha += entry * formation.x(agent);
      beta += entry * formation.y(agent);
    }
    return [alpha, beta];
  });
}

/** The formation as its first `count` modes have it: x, y an agent, meters. All of them give it back. */
export function partialFormation(basis: ModeBasis, coefficients: readonly Point[], count: number): Float64Array {
  const xy = new Float64Array(2 * basis.agentCount);
  for (let index = 0; index < Math.min(count, basis.shownCount); index += 1) {
    const mode = basis.mode(index);
    const [alpha, beta] = coefficients[index] ?? [0, 0];
    for (let agent = 0; agent < basis.agentCount; agent += 1) {
      const entry = mode[agent] ?? 0;
      xy[2 * agent] = (xy[2 * agent] ?? 0) + entry * alpha;
      xy[2 * agent + 1] = (xy[2 * agent + 1] ?? 0) + entry * beta;
    }
  }
  return xy;
}

/** How far places are from where the agents stand: root of the mean squared distance, meters. */
export function rmsError(xy: Float64Array, formation: Formation): number {
  let sum = 0;
  for (let k = 0; k < xy.length; k += 1) sum += ((xy[k] ?? 0) - (formation.xy[k] ?? 0)) ** 2;
  return formation.agentCount === 0 ? 0 : Math.sqrt(sum / formation.agentCount);
}

/** Entries this small beside the greatest are zero up to round-off: on neither side. */
const NO_SIDE = 1e-9;

/** Which side of a mode each agent is on: 1, −1, or 0 for neither. */
export function sidesOf(mode: Float64Array): Int8Array {
  const greatest = mode.reduce((most, entry) => Math.max(most, Math.abs(entry)), 0);
  return Int8Array.from(mode, (entry) => (Math.abs(entry) <= NO_SIDE * greatest ? 0 : Math.sign(entry)));
}

/** Ties as pairs of places in a list of agents; without those to others. */
export function pairsAmong(agents: readonly number[], pairs: Uint32Array): Uint32Array {
  const places = new Map(agents.map((agent, place) => [agent, place]));
  const among: number[] = [];
  for (let k = 0; k + 1 < pairs.length; k += 2) {
    const [a, b] = [places.get(pairs[k] ?? 0), places.get(pairs[k + 1] ?? 0)];
    if (a !== undefined && b !== undefined) among.push(a, b);
  }
  return Uint32Array.from(among);
}

/** The ties that join two sides, as pairs: a0, b0, a1, … */
export function cutPairs(pairs: Uint32Array, sides: Int8Array): Uint32Array {
  const cut: number[] = [];
  for (let k = 0; k + 1 < pairs.length; k += 2) {
    const [a, b] = [pairs[k] ?? 0, pairs[k + 1] ?? 0];
    if ((sides[a] ?? 0) * (sides[b] ?? 0) < 0) cut.push(a, b);
  }
  return Uint32Array.from(cut);
}

/**
 * Where a mode changes its sign, as strokes x0, y0, x1, y1 in meters: straight through every triangle of ties that it
 * crosses, its entries taken to run evenly along a tie.
 */
export function cutLine(mode: Float64Array, formation: Formation, triangles: Uint32Array): Float64Array {
  const strokes: number[] = [];
  for (let k = 0; k + 2 < triangles.length; k += 3) {
    const [a, b, c] = [triangles[k] ?? 0, triangles[k + 1] ?? 0, triangles[k + 2] ?? 0];
    const crossings: number[] = [];
    for (const [from, to] of [
      [a, b],
      [b, c],
      [c, a],
    ] as const) {
      const [e, f] = [mode[from] ?? 0, mode[to] ?? 0];
      if (e < 0 === f < 0) continue;
      const t = e / (e - f);
      crossings.push(
        formation.x(from) + t * (formation.x(to) - formation.x(from)),
        formation.y(from) + t * (formation.y(to) - formation.y(from)),
      );
    }
    if (crossings.length === 4) strokes.push(...crossings);
  }
  return Float64Array.from(strokes);
}

/** Mean and least of how alike paired modes are, 0..1. */
export function likenessAlong(amounts: readonly number[]): { readonly mean: number; readonly least: number } {
  if (amounts.length === 0) return { mean: 1, least: 1 };
  const sum = amounts.reduce((total, amount) => total + amount, 0);
  return { mean: sum / amounts.length, least: Math.min(...amounts) };
}
