import { clipText, LIMITS } from "../limits";
import { crossesItself } from "../obstacle";
import type { AdjacencySpec, Obstacle, ObstacleShape, Scene } from "../scene";
import type { Command } from "../store";
import { changeScope, WHOLE_SCENE } from "./ties";

/** Something to go around, throughout the show. Nothing happens where its outline is none or there are too many. */
export function addObstacle(shape: ObstacleShape): Command {
  return {
    label: "Add obstacle",
    apply: (scene) =>
      isOutline(shape) && scene.obstacles.length < LIMITS.obstacles
        ? { ...scene, obstacles: [...scene.obstacles, { name: "", shape }] }
        : scene,
  };
}

export function setObstacleShape(index: number, shape: ObstacleShape, label = "Change obstacle"): Command {
  return {
    label,
    apply: (scene) => (isOutline(shape) ? updateObstacle(scene, index, (was) => ({ ...was, shape })) : scene),
  };
}

export function renameObstacle(index: number, name: string): Command {
  return {
    label: "Rename obstacle",
    apply: (scene) => {
      const clipped = clipText(name.trim(), LIMITS.name);
      return updateObstacle(scene, index, (was) => (was.name === clipped ? was : { ...was, name: clipped }));
    },
  };
}

/** Ties to it go with it. */
export function deleteObstacle(index: number): Command {
  return {
    label: "Delete obstacle",
    apply: (scene) =>
      scene.obstacles[index]
        ? changeScope({ ...scene, obstacles: scene.obstacles.toSpliced(index, 1) }, WHOLE_SCENE, (was) =>
            withoutObstacle(was, index),
          )
        : scene,
  };
}

/** Whether a shape goes around something once, within what a scene may hold. */
export function isOutline(shape: ObstacleShape): boolean {
  const isAdmissible = (value: number) => Math.abs(value) <= LIMITS.coordinate;
  if (shape.kind === "circle") {
    return shape.radius > 0 && shape.radius <= LIMITS.coordinate && shape.center.every(isAdmissible);
  }
  const { points } = shape;
  const isCounted = points.length >= 3 && points.length <= LIMITS.obstaclePoints;
  const isAround = Math.abs(areaOf(points)) > 0 && !crossesItself(points);
  return isCounted && points.flat().every(isAdmissible) && isAround;
}

function areaOf(points: readonly (readonly [number, number])[]): number {
  return points.reduce((sum, [x, y], index) => {
    const [nextX, nextY] = points[(index + 1) % points.length] ?? [x, y];
    return sum + (x * nextY - nextX * y) / 2;
  }, 0);
}

function updateObstacle(scene: Scene, index: number, change: (obstacle: Obstacle) => Obstacle): Scene {
  const obstacle = scene.obstacles[index];
  const next = obstacle && change(obstacle);
  return next && next !== obstacle ? { ...scene, obstacles: scene.obstacles.with(index, next) } : scene;
}

function withoutObstacle(was: AdjacencySpec, gone: number): AdjacencySpec {
  if (was.obstacleTies.every(([, obstacle]) => obstacle < gone)) return was;
  const obstacleTies = was.obstacleTies
    .filter(([, obstacle]) => obstacle !== gone)
    .map(([agent, obstacle, factor]) => [agent, obstacle > gone ? obstacle - 1 : obstacle, factor] as const);
  return { ...was, obstacleTies };
}
