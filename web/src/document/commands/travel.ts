import { updateKeyframe, updateSegment } from "../edit";
import { barycenterOf, Formation, type Point } from "../formation";
import { clampCoordinate } from "../limits";
import type { TravelPath } from "../scene";
import { snapApart, snapOf } from "../snap";
import type { Command } from "../store";

/** What the formation of a transition travels along; null for the method's own way. Auto chooses again. A path has a length. */
export function setPath(index: number, points: readonly Point[] | null, label: string, series?: string): Command {
  const path: TravelPath | null =
    points?.map(([x, y]): [number, number] => [clampCoordinate(x), clampCoordinate(y)]) ?? null;
  const [first] = path ?? [];
  const isNowhere = path?.every(([x, y]) => x === first?.[0] && y === first?.[1]) ?? false;
  return {
    label,
    ...(series === undefined ? {} : { series }),
    apply: (scene) =>
      updateSegment(scene, index, (was) => (isNowhere || was.path === path ? was : { ...was, path, chosen: null })),
  };
}

/** Turn everybody of a keyframe about their barycenter, radians: the formation that a path would bring there. */
export function turnFormation(keyframe: number, angle: number): Command {
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  return {
    label: "Turn the formation along",
    apply: (scene) =>
      updateKeyframe(scene, keyframe, (was) => {
        const [cx, cy] = barycenterOf(was.positions);
        const turned = was.positions.points().map(([x, y]): Point => {
          const [dx, dy] = [x - cx, y - cy];
          return [clampCoordinate(cx + cos * dx - sin * dy), clampCoordinate(cy + sin * dx + cos * dy)];
        });
        const settled = Formation.from(snapApart(turned, snapOf(scene)));
        return { ...was, positions: settled.withHeights(was.positions.heights) };
      }),
  };
}
