import { type Box, boxOf } from "../box";
import { DEFAULT_AGENT } from "../defaults";
import { chooseAllAgain, updateKeyframe, updateTrack } from "../edit";
import type { Formation, Point } from "../formation";
import { clampCoordinate, clipText, LIMITS, withinLimits } from "../limits";
import { type Agent, type Group, mainTrack, type Scene } from "../scene";
import type { Command } from "../store";
import { setBetween } from "./keyframes";
import { followNodes } from "./nodes";
import { dropFromAdjacency, dropFromGroups, dropFromLocks, pathAfterDrop } from "./reindex";

/** Move some agents at one keyframe, meters: together as far as the one in front can go. */
export function moveAgents(keyframe: number, agents: ReadonlySet<number>, by: Point, label = "Move agents"): Command {
  return {
    label,
    apply: (scene) => {
      const positions = mainTrack(scene).keyframes[keyframe]?.positions;
      const box = positions && boxOf(positions, agents);
      if (!box || (by[0] === 0 && by[1] === 0)) return scene;
      const [right, up] = [possible(by[0], box, 0), possible(by[1], box, 1)];
      return putAgents(
        scene,
        keyframe,
        [...agents].map((a) => [a, [positions.x(a) + right, positions.y(a) + up]]),
      );
    },
  };
}

/** How far a box can go along an axis, of the way it is to go; meters. */
function possible(way: number, { min, max }: Box, axis: 0 | 1): number {
  return Math.max(-LIMITS.coordinate - min[axis], Math.min(LIMITS.coordinate - max[axis], way));
}

/** Put one agent at exact coordinates, meters. */
export function setPlace(keyframe: number, agent: number, place: Point): Command {
  return { label: "Move agent", apply: (scene) => putAgents(scene, keyframe, [[agent, place]]) };
}

/**
 * Put agents on slots at one keyframe: `agents[i]` takes `slots[order[i]]`.
 *
 * @param order a permutation of the slots, as many as agents
 */
export function placeAgents(
  keyframe: number,
  agents: readonly number[],
  slots: readonly Point[],
  order: ArrayLike<number>,
  label = "Place agents",
): Command {
  return {
    label,
    apply: (scene) =>
      putAgents(
        // Where everybody is given a new place, another formation begins.
        agents.length === mainTrack(scene).agents.length ? setBetween(keyframe, false).apply(scene) : scene,
        keyframe,
        agents.flatMap((agent, i) => {
          const slot = slots[order[i] ?? -1];
          return slot ? [[agent, slot] as const] : [];
        }),
      ),
  };
}

/** New agents at the given places, the same in every keyframe. */
export function addAgents(
  places: readonly Point[],
  label = "Add agents",
  agents: readonly Partial<Agent>[] = [],
): Command {
  return {
    label,
    apply: (scene) =>
      append(
        scene,
        places.map((place, i) => ({ agent: { ...DEFAULT_AGENT, ...agents[i] }, at: () => place })),
      ),
  };
}

/** A copy of each agent, beside it in every keyframe and in the same group. */
export function duplicateAgents(agents: ReadonlySet<number>, by: Point): Command {
  return {
    label: agents.size === 1 ? "Duplicate agent" : "Duplicate agents",
    apply: (scene) => {
      const track = mainTrack(scene);
      const originals = [...agents].filter((agent) => track.agents[agent]).sort((a, b) => a - b);
      const first = track.agents.length;
      const next = append(
        scene,
        originals.map((original) => ({
          agent: { ...DEFAULT_AGENT, ...track.agents[original] },
          at: (formation) => [formation.x(original) + by[0], formation.y(original) + by[1]],
        })),
      );
      if (next === scene) return scene;
      const copies = new Map(originals.map((original, i) => [original, first + i]));
      return { ...next, groups: joinGroups(scene.groups, copies) };
    },
  };
}

export function deleteAgents(agents: ReadonlySet<number>): Command {
  return {
    label: agents.size === 1 ? "Delete agent" : "Delete agents",
    apply: (scene) => {
      const track = mainTrack(scene);
      const kept = [...track.agents.keys()].filter((agent) => !agents.has(agent));
      if (kept.length === track.agents.length) return scene;
      const places = new Map(kept.map((agent, place) => [agent, place]));
      const next = updateTrack(scene, (was) => ({
        ...was,
        segments: was.segments.map((segment) => dropFromLocks(segment, places)),
        agents: kept.flatMap((agent) => was.agents[agent] ?? []),
        keyframes: was.keyframes.map((keyframe) => ({
          ...keyframe,
          positions: keyframe.positions.select(kept),
          absent: keyframe.absent.flatMap((agent) => places.get(agent) ?? []),
          adjacency: keyframe.adjacency && dropFromAdjacency(keyframe.adjacency, places),
        })),
      }));
      const left = {
        ...next,
        groups: dropFromGroups(scene.groups, places),
        adjacency: dropFromAdjacency(scene.adjacency, places),
      };
      return chooseAllAgain(followNodes(scene, left, (path) => pathAfterDrop(scene.groups, places, path)));
    },
  };
}

export function renameAgent(agent: number, name: string): Command {
  return {
    label: "Rename agent",
    apply: (scene) => updateAgents(scene, [agent], { name: clipText(name.trim(), LIMITS.name) }),
  };
}

/** @param color `#rrggbb`, or empty for the color of the group */
export function colorAgents(agents: Iterable<number>, color: string): Command {
  const chosen = [...agents];
  return { label: "Color agents", apply: (scene) => updateAgents(scene, chosen, { color }) };
}

/** @param radius of the body, meters */
export function setRadius(agents: Iterable<number>, radius: number): Command {
  const chosen = [...agents];
  const isSize = radius >= 0 && radius <= LIMITS.length;
  return { label: "Resize agents", apply: (scene) => (isSize ? updateAgents(scene, chosen, { radius }) : scene) };
}

/** @param limit m/s; null: as fast as they like */
export function setTopSpeed(agents: Iterable<number>, limit: number | null): Command {
  const chosen = [...agents];
  const { min, max } = LIMITS.maxSpeed;
  const maxSpeed = limit === null ? null : Math.min(max, Math.max(min, limit));
  return { label: "Limit speed", apply: (scene) => updateAgents(scene, chosen, { maxSpeed }) };
}

/** The scene with agents put somewhere at one keyframe; the same scene when they are there already. */
export function putAgents(
  scene: Scene,
  keyframe: number,
  places: Iterable<readonly [agent: number, place: Point]>,
): Scene {
  const agentCount = mainTrack(scene).agents.length;
  return updateKeyframe(scene, keyframe, (was) => {
    const moved = [...places]
      .filter(([agent, [x, y]]) => agent < agentCount && Number.isFinite(x) && Number.isFinite(y))
      .map(([agent, [x, y]]) => [agent, [clampCoordinate(x), clampCoordinate(y)] as const] as const)
      .filter(([agent, [x, y]]) => x !== was.positions.x(agent) || y !== was.positions.y(agent));
    return moved.length > 0 ? { ...was, positions: was.positions.with(moved) } : was;
  });
}

function updateAgents(scene: Scene, agents: readonly number[], patch: Partial<Agent>): Scene {
  return updateTrack(scene, (track) => {
    const chosen = new Set(agents);
    const next = track.agents.map((agent, index) => {
      const isChanged =
        chosen.has(index) && Object.entries(patch).some(([key, value]) => agent[key as keyof Agent] !== value);
      return isChanged ? { ...agent, ...patch } : agent;
    });
    return next.some((agent, index) => agent !== track.agents[index]) ? { ...track, agents: next } : track;
  });
}

interface Newcomer {
  readonly agent: Agent;
  readonly at: (formation: Formation) => Point;
}

function append(scene: Scene, newcomers: readonly Newcomer[]): Scene {
  if (newcomers.length === 0) return scene;
  const next = updateTrack(scene, (track) => ({
    ...track,
    agents: [...track.agents, ...newcomers.map(({ agent }) => agent)],
    keyframes: track.keyframes.map((keyframe) => ({
      ...keyframe,
      positions: keyframe.positions.add(
        newcomers.map(({ at }): Point => {
          const [x, y] = at(keyframe.positions);
          return [clampCoordinate(x), clampCoordinate(y)];
        }),
      ),
    })),
  }));
  return withinLimits(scene, chooseAllAgain(next));
}

function joinGroups(groups: readonly Group[], copies: ReadonlyMap<number, number>): readonly Group[] {
  return groups.map((group) => ({
    ...group,
    members: [...group.members, ...group.members.flatMap((member) => copies.get(member) ?? [])],
    children: [...joinGroups(group.children, copies)],
  }));
}
