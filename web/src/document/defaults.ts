import { Formation } from "./formation";
import { CROWD_DEFAULTS } from "./generated";
import type { AdjacencySpec, Agent, Keyframe, Scene, Segment, Stage } from "./scene";

/** Meters; what the page writes into new scenes, where an absent field means no limit. */
export const NEW_MINIMUM_DISTANCE = 0.5;

export const DEFAULT_STAGE: Stage = { width: 100, depth: 60, height: 0, backdrop: "grid", units: "m" };
export const DEFAULT_AGENT: Agent = { name: "", color: "", radius: 0.25, maxSpeed: null };
export const DEFAULT_ADJACENCY: AdjacencySpec = {
  base: "delaunay",
  weights: "inverse",
  ties: [],
  cuts: [],
  obstacleTies: [],
};
export const DEFAULT_SEGMENT: Segment = {
  kind: "transition",
  method: "auto",
  chosen: null,
  order: "greedy",
  alignment: "pca",
  sharing: 0.5,
  keepSize: false,
  timing: "smooth",
  avoidance: true,
  hierarchy: false,
  nodes: [],
  path: null,
  crowd: CROWD_DEFAULTS,
  assignment: null,
};

export function keyframeAt(time: number, positions: Formation): Keyframe {
  return { name: "", time, hold: 0, corner: false, between: 0, positions, absent: [], adjacency: null };
}

/** A new scene as the page makes it: one keyframe, nobody on it. */
export function emptyScene(): Scene {
  return {
    title: "",
    seed: 0,
    stage: DEFAULT_STAGE,
    tempo: { beatsPerMinute: 120, beatsPerBar: 4, start: 0 },
    frameRate: 30,
    minimumDistance: NEW_MINIMUM_DISTANCE,
    join: "smooth",
    tension: 0.5,
    groups: [],
    adjacency: DEFAULT_ADJACENCY,
    tracks: [{ agents: [], keyframes: [keyframeAt(0, Formation.from([]))], segments: [] }],
    obstacles: [],
  };
}
