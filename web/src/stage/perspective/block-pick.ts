import { distanceTo } from "../../document/obstacle";
import type { Obstacle } from "../../document/scene";
import type { ScreenPoint } from "../camera";
import type { Sight } from "./sight";

/** Places that are looked at on the way of a ray from a block's top down to the ground. */
const PLACES = 12;

/** The obstacle under a place of the screen, `height` meters high each, the nearest to the eye; null where there is none. */
export function blockAt(sight: Sight, obstacles: readonly Obstacle[], height: number, at: ScreenPoint): number | null {
  const [over, under] = [sight.levelAt(at, height), sight.levelAt(at, 0)];
  if (!over || !under) return null;
  for (let place = 0; place <= PLACES; place += 1) {
    const t = place / PLACES;
    const x = over[0] + (under[0] - over[0]) * t;
    const y = over[1] + (under[1] - over[1]) * t;
    const index = obstacles.findLastIndex(({ shape }) => distanceTo(shape, [x, y]) === 0);
    if (index >= 0) return index;
  }
  return null;
}
