import { obstacleLabel } from "../document/obstacle";
import { agentLabel } from "../document/queries";
import type { Scene } from "../document/scene";
import { lengthWithUnit } from "../document/units";
import type { NoWay } from "../engine/api";

/** Whom an obstacle shuts off on a way of the motion, and what to do. */
export function shutOffWords(scene: Scene, { agent, obstacle, distance }: NoWay): string {
  const gap = lengthWithUnit(2 * distance, scene.stage.units);
  return (
    `No way leads agent ${agentLabel(scene, agent)} to its place, so it goes through: ` +
    `${obstacleLabel(scene, obstacle)} shuts it off. Move the obstacle, or leave a gap of ${gap}.`
  );
}

/** Whom an obstacle shuts off from a place, and what to do: by the names that the page shows. */
export function noWayWords(scene: Scene, { agent, obstacle, distance }: NoWay): string {
  const gap = lengthWithUnit(2 * distance, scene.stage.units);
  return (
    `No way leads agent ${agentLabel(scene, agent)} to a place that is left for it: ` +
    `${obstacleLabel(scene, obstacle)} shuts it off. Move the obstacle, leave a gap of ${gap}, ` +
    "or lock the agent to a place beyond."
  );
}
