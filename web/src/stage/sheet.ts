import type { Scene, Stage } from "../document/scene";
import { mainTrack } from "../document/scene";
import { type Bounds, boundsOf, grown, union } from "./camera";
import { neighborSpacing } from "./spacing";

/** Meters; x runs between the goals. */
export const FOOTBALL = { yard: 0.9144, goalToGoal: 91.44, endZone: 9.144, depth: 48.768 } as const;
export const SOCCER = { length: 105, depth: 68 } as const;

/** The drawing surface: a field has its own size, everything else the stage's. */
export function sheetOf(stage: Stage): Bounds {
  switch (stage.backdrop) {
    case "football-college":
    case "football-hs":
      return centered(FOOTBALL.goalToGoal + 2 * FOOTBALL.endZone, FOOTBALL.depth);
    case "soccer":
      return centered(SOCCER.length, SOCCER.depth);
    default:
      return centered(stage.width, stage.depth);
  }
}

/** Everything the scene shows: where its agents ever stand at a keyframe, with room for their discs; null without agents. */
export function contentOf(scene: Scene): Bounds | null {
  let content: Bounds | null = null;
  for (const keyframe of mainTrack(scene).keyframes) {
    const bounds = boundsOf(keyframe.positions.xy);
    if (!bounds) continue;
    const extent = Math.max(bounds.maxX - bounds.minX, bounds.maxY - bounds.minY);
    const spacing = neighborSpacing(keyframe.positions);
    const roomy = grown(bounds, Math.min(Number.isFinite(spacing) ? spacing : 1, Math.max(0.06 * extent, 0.5)));
    content = content ? union(content, roomy) : roomy;
  }
  return content;
}

function centered(width: number, depth: number): Bounds {
  return { minX: -width / 2, maxX: width / 2, minY: -depth / 2, maxY: depth / 2 };
}
