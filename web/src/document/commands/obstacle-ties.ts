import { LIMITS } from "../limits";
import { type AdjacencySpec, mainTrack, type Scene } from "../scene";
import type { Command } from "../store";
import { changeScope, type TieScope } from "./ties";

/** An agent keeps its clearance to an obstacle, as firmly as the factor says; a factor there is replaced. */
export function tieToObstacle(scope: TieScope, agent: number, obstacle: number, factor = 1): Command {
  return {
    label: "Tie to the obstacle",
    apply: (scene) => {
      if (!mainTrack(scene).agents[agent] || !scene.obstacles[obstacle] || !(factor > 0)) return scene;
      const clamped = Math.max(LIMITS.factor.min, Math.min(LIMITS.factor.max, factor));
      return changeScope(scene, scope, (was) => withFactor(was, agent, obstacle, clamped));
    },
  };
}

export function untieFromObstacle(scope: TieScope, agent: number, obstacle: number): Command {
  return {
    label: "Untie from the obstacle",
    apply: (scene) =>
      changeScope(scene, scope, (was) => {
        const obstacleTies = was.obstacleTies.filter((tie) => !joins(tie, agent, obstacle));
        return obstacleTies.length === was.obstacleTies.length ? was : { ...was, obstacleTies };
      }),
  };
}

/** The agents tied to an obstacle, each with its factor. */
export function tiesTo(scene: Scene, obstacle: number): readonly (readonly [agent: number, factor: number])[] {
  return scene.adjacency.obstacleTies
    .filter(([, other]) => other === obstacle)
    .map(([agent, , factor]) => [agent, factor] as const);
}

function withFactor(was: AdjacencySpec, agent: number, obstacle: number, factor: number): AdjacencySpec {
  const before = was.obstacleTies.find((tie) => joins(tie, agent, obstacle));
  if (before?.[2] === factor) return was;
  const others = was.obstacleTies.filter((tie) => tie !== before);
  return { ...was, obstacleTies: [...others, [agent, obstacle, factor] as const] };
}

function joins([a, o]: AdjacencySpec["obstacleTies"][number], agent: number, obstacle: number): boolean {
  return a === agent && o === obstacle;
}
