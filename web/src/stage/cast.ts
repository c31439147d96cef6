import { DEFAULT_AGENT } from "../document/defaults";
import { groupAt, groupPaths, groupSet } from "../document/groups";
import { agentColors, agentLabel, groupColor } from "../document/queries";
import { type Agent, type GroupPath, mainTrack, type Scene } from "../document/scene";
import { inkOn } from "./contrast";
import type { Palette } from "./palette";
import { shortName } from "./short-name";

/** Agents of one color, so that a color is set once a frame. */
export interface Paint {
  /** As shown, `#rrggbb`. */
  readonly color: string;
  /** What reads on it. */
  readonly ink: string;
  readonly agents: Uint32Array;
}

/** A group as it is drawn. */
export interface CastGroup {
  readonly path: GroupPath;
  /** As shown. */
  readonly color: string;
  readonly agents: Uint32Array;
}

/** Who is on stage: colors, names and groups of a scene in one theme. */
export interface Cast {
  /** As shown, by agent. */
  readonly colors: readonly string[];
  /** What reads on an agent's color, by agent. */
  readonly inks: readonly string[];
  readonly names: readonly string[];
  /** What fits in a disc. */
  readonly shortNames: readonly string[];
  readonly paints: readonly Paint[];
  /** By agent, the radius of its body, meters, where it has one of its own; null while nobody has. */
  readonly bodies: readonly (number | null)[] | null;
  /** Parents before children. */
  readonly groups: readonly CastGroup[];
}

export function castOf(scene: Scene, palette: Palette): Cast {
  const { agents } = mainTrack(scene);
  const isOwn = ({ radius }: Agent) => radius !== DEFAULT_AGENT.radius;
  const colors = agentColors(scene).map((stored) => palette.shown(stored));
  const byColor = new Map<string, number[]>();
  colors.forEach((color, agent) => {
    const agents = byColor.get(color);
    if (agents) agents.push(agent);
    else byColor.set(color, [agent]);
  });
  const paints = [...byColor].map(([color, agents]) => ({
    color,
    ink: inkOn(color),
    agents: Uint32Array.from(agents),
  }));
  const inks = new Map(paints.map(({ color, ink }) => [color, ink]));
  const names = agents.map((_, agent) => agentLabel(scene, agent));
  return {
    colors,
    inks: colors.map((color) => inks.get(color) ?? palette.ink),
    names,
    shortNames: names.map(shortName),
    paints,
    bodies: agents.some(isOwn) ? agents.map((agent) => (isOwn(agent) ? agent.radius : null)) : null,
    groups: groupPaths(scene.groups).map((path) => {
      const group = groupAt(scene.groups, path);
      return {
        path,
        color: palette.shown(groupColor(scene, path)),
        agents: Uint32Array.from(group ? groupSet(group) : []).sort(),
      };
    }),
  };
}
