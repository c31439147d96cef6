import type { Point } from "../../document/formation";
import type { Bounds } from "../camera";
import { clamp } from "../spacing";

/** An eye that looks at a place of the stage. Meters; radians. */
export interface Orbit {
  /** What is looked at; z is up. */
  readonly x: number;
  readonly y: number;
  readonly z: number;
  /** From the eye to it. */
  readonly distance: number;
  /** Around the vertical: 0 looks from the audience, a quarter turn from its right. */
  readonly azimuth: number;
  /** Above the ground: a quarter turn looks straight down. */
  readonly elevation: number;
}

/** How far an orbit may go. */
export interface Reach {
  /** Where what is looked at stays. */
  readonly bounds: Bounds;
  /** Meters between eye and target. */
  readonly nearest: number;
  readonly farthest: number;
}

/** Never below the ground, which is seen from above only. */
const LOWEST = 0.05;
const HIGHEST = Math.PI / 2;

/** The eye goes around and up, radians. */
export function turned(orbit: Orbit, azimuth: number, elevation: number): Orbit {
  return {
    ...orbit,
    azimuth: orbit.azimuth + azimuth,
    elevation: clamp(orbit.elevation + elevation, LOWEST, HIGHEST),
  };
}

/** Eye and target move over the ground, meters. */
export function slid(orbit: Orbit, dx: number, dy: number, { bounds }: Reach): Orbit {
  return {
    ...orbit,
    x: clamp(orbit.x + dx, bounds.minX, bounds.maxX),
    y: clamp(orbit.y + dy, bounds.minY, bounds.maxY),
  };
}

/** The eye comes `factor` times as near; what stands at `about` on the ground stays where it is on the screen. */
export function nearer(orbit: Orbit, factor: number, about: Point, reach: Reach): Orbit {
  const distance = clamp(orbit.distance / factor, reach.nearest, reach.farthest);
  const share = distance / orbit.distance;
  const moved = slid(orbit, (about[0] - orbit.x) * (1 - share), (about[1] - orbit.y) * (1 - share), reach);
  return { ...moved, z: orbit.z * share, distance };
}

/** The orbit `t` of the way between two: the shorter way around, and distances as evenly as the eye sees them. */
export function between(from: Orbit, to: Orbit, t: number): Orbit {
  if (t <= 0) return from;
  if (t >= 1) return to;
  const mixed = (a: number, b: number) => a + (b - a) * t;
  return {
    x: mixed(from.x, to.x),
    y: mixed(from.y, to.y),
    z: mixed(from.z, to.z),
    distance: from.distance * (to.distance / from.distance) ** t,
    azimuth: from.azimuth + shortestTurn(to.azimuth - from.azimuth) * t,
    elevation: mixed(from.elevation, to.elevation),
  };
}

/** Whether two orbits see the same. */
export function areSame(one: Orbit, other: Orbit): boolean {
  return (Object.keys(one) as (keyof Orbit)[]).every((key) => one[key] === other[key]);
}

/** The same direction within half a turn either way. */
export function shortestTurn(angle: number): number {
  return angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));
}
