import type { ScreenPoint } from "../camera";
import { bodyAt } from "./pick";
import type { Sight } from "./sight";

/** Bodies that a pointer can meet, meters; one is kept and refilled. */
export interface Meetable {
  /** x, y, z an agent. */
  place: Float32Array;
  /** From the ground to the top of the head, and half the width, of most; and by agent, how large it is beside them. */
  height: number;
  radius: number;
  shares: Float32Array;
}

/** Finds who is under a place of the screen. Owns its buffers, which are filled when it is asked. */
export function createFinger(): (bodies: Meetable, sight: Sight, at: ScreenPoint, slack: number) => number | null {
  let feet = new Float32Array(0);
  let heads = new Float32Array(0);
  let halfWidths = new Float32Array(0);
  return ({ place, height, radius, shares }, sight, at, slack) => {
    const count = place.length / 3;
    if (halfWidths.length !== count) {
      feet = new Float32Array(3 * count);
      heads = new Float32Array(3 * count);
      halfWidths = new Float32Array(count);
    }
    for (let agent = 0; agent < count; agent += 1) {
      const x = place[3 * agent] ?? 0;
      const y = place[3 * agent + 1] ?? 0;
      const z = place[3 * agent + 2] ?? 0;
      sight.projectInto(x, y, z, feet, 3 * agent);
      const share = shares[agent] ?? 1;
      sight.projectInto(x, y, z + height * share, heads, 3 * agent);
      halfWidths[agent] = (radius * share * sight.focal) / Math.max(feet[3 * agent + 2] ?? 0, 1e-3);
    }
    return bodyAt(feet, heads, halfWidths, at, slack);
  };
}
