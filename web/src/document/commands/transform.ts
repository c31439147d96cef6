import { boxOf, centerOf } from "../box";
import type { Formation, Point } from "../formation";
import { mainTrack, type Scene } from "../scene";
import { snapOf, snapPoint } from "../snap";
import type { Command } from "../store";
import { putAgents } from "./agents";

/**
 * Turn agents about a place.
 *
 * @param angle radians, counterclockwise
 */
export function rotateAgents(keyframe: number, agents: ReadonlySet<number>, about: Point, angle: number): Command {
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  const turn = ([x, y]: Point): Point => {
    const [dx, dy] = [x - about[0], y - about[1]];
    return [about[0] + cos * dx - sin * dy, about[1] + sin * dx + cos * dy];
  };
  return { label: "Rotate agents", apply: (scene) => (angle === 0 ? scene : mapPlaces(scene, keyframe, agents, turn)) };
}

/** Stretch agents away from a place that stays, by a factor along x and one along y. */
export function scaleAgents(keyframe: number, agents: ReadonlySet<number>, anchor: Point, factor: Point): Command {
  const stretch = ([x, y]: Point): Point => [
    anchor[0] + factor[0] * (x - anchor[0]),
    anchor[1] + factor[1] * (y - anchor[1]),
  ];
  const isNone = factor[0] === 1 && factor[1] === 1;
  return { label: "Scale agents", apply: (scene) => (isNone ? scene : mapPlaces(scene, keyframe, agents, stretch)) };
}

/** Mirror agents about the middle of their box: `horizontal` swaps left and right. */
export function flipAgents(keyframe: number, agents: ReadonlySet<number>, way: "horizontal" | "vertical"): Command {
  return {
    label: way === "horizontal" ? "Flip horizontally" : "Flip vertically",
    apply: (scene) => {
      const box = boxAt(scene, keyframe, agents);
      if (!box) return scene;
      const [x0, y0] = [box.min[0] + box.max[0], box.min[1] + box.max[1]];
      return mapPlaces(scene, keyframe, agents, ([x, y]) => (way === "horizontal" ? [x0 - x, y] : [x, y0 - y]));
    },
  };
}

export type Edge = "left" | "center" | "right" | "top" | "middle" | "bottom";

/** Bring agents onto one edge, or the middle, of their box. */
export function alignAgents(keyframe: number, agents: ReadonlySet<number>, edge: Edge): Command {
  return {
    label: `Align ${edge}`,
    apply: (scene) => {
      const box = boxAt(scene, keyframe, agents);
      if (!box) return scene;
      const center = centerOf(box);
      const onto: Record<Edge, (place: Point) => Point> = {
        left: ([, y]) => [box.min[0], y],
        center: ([, y]) => [center[0], y],
        right: ([, y]) => [box.max[0], y],
        top: ([x]) => [x, box.max[1]],
        middle: ([x]) => [x, center[1]],
        bottom: ([x]) => [x, box.min[1]],
      };
      return mapPlaces(scene, keyframe, agents, onto[edge]);
    },
  };
}

/** Even out the gaps between agents along one axis; the outermost two stay. */
export function distributeAgents(keyframe: number, agents: ReadonlySet<number>, along: "x" | "y"): Command {
  return {
    label: along === "x" ? "Distribute horizontally" : "Distribute vertically",
    apply: (scene) => {
      const positions = positionsAt(scene, keyframe);
      if (!positions || agents.size < 3) return scene;
      const axis = along === "x" ? 0 : 1;
      const ordered = [...agents].sort((a, b) => positions.point(a)[axis] - positions.point(b)[axis] || a - b);
      const first = positions.point(ordered[0] ?? 0)[axis];
      const last = positions.point(ordered.at(-1) ?? 0)[axis];
      const snap = snapOf(scene);
      const places = ordered.map((agent, i): readonly [number, Point] => {
        const [x, y] = positions.point(agent);
        if (i === 0 || i === ordered.length - 1) return [agent, [x, y]];
        const at = first + ((last - first) * i) / (ordered.length - 1);
        return [agent, along === "x" ? [snapPoint([at, y], snap)[0], y] : [x, snapPoint([x, at], snap)[1]]];
      });
      return putAgents(scene, keyframe, places);
    },
  };
}

function mapPlaces(scene: Scene, keyframe: number, agents: ReadonlySet<number>, map: (place: Point) => Point): Scene {
  const positions = positionsAt(scene, keyframe);
  if (!positions) return scene;
  const snap = snapOf(scene);
  return putAgents(
    scene,
    keyframe,
    Array.from(agents, (agent) => {
      const place = positions.point(agent);
      const [x, y] = map(place);
      // A coordinate the change leaves alone stays exactly where it is, on the lattice or not.
      const [sx, sy] = snapPoint([x, y], snap);
      return [agent, [x === place[0] ? x : sx, y === place[1] ? y : sy]] as const;
    }),
  );
}

function positionsAt(scene: Scene, keyframe: number): Formation | undefined {
  return mainTrack(scene).keyframes[keyframe]?.positions;
}

function boxAt(scene: Scene, keyframe: number, agents: ReadonlySet<number>) {
  const positions = positionsAt(scene, keyframe);
  return positions ? boxOf(positions, agents) : null;
}
