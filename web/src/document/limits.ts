import { groupDepth, groupPaths } from "./groups";
import { mainTrack, type Scene } from "./scene";

/** What a scene may hold; the engine refuses more, so no command makes more. */
export const LIMITS = {
  agents: 5000,
  keyframes: 200,
  places: 200_000,
  frames: 20_000_000,
  groups: 1000,
  groupDepth: 8,
  name: 64,
  title: 200,
  coordinate: 1e5,
  length: 1e5,
  maxSpeed: { min: 0.01, max: 1000 },
  seconds: 3600,
  frameRate: { min: 1, max: 120 },
  factor: { min: 1e-6, max: 1e6 },
  ties: 50_000,
  obstacles: 200,
  obstaclePoints: 200,
} as const;

/** Seconds between the end of a keyframe and the next, at least. */
export const SHORTEST_TRANSITION = 0.1;

/** The end of the show, seconds. */
export function durationOf(scene: Scene): number {
  const last = mainTrack(scene).keyframes.at(-1);
  return last ? last.time + last.hold : 0;
}

/** Which limit a scene would break, in a sentence; null when it breaks none. */
export function brokenLimit(scene: Scene): string | null {
  const track = mainTrack(scene);
  const agents = track.agents.length;
  const keyframes = track.keyframes.length;
  const frames = frameCount(scene);
  if (agents > LIMITS.agents) return `A scene has at most ${count(LIMITS.agents)} agents.`;
  if (keyframes > LIMITS.keyframes) return `A scene has at most ${LIMITS.keyframes} keyframes.`;
  if (agents * keyframes > LIMITS.places) {
    return `${count(agents)} agents can have at most ${Math.floor(LIMITS.places / agents)} keyframes.`;
  }
  if (durationOf(scene) > LIMITS.seconds) return "A scene lasts at most one hour.";
  if (agents * frames > LIMITS.frames) {
    return `${count(agents)} agents for ${Math.round(durationOf(scene))} s are too many frames: lower the frame rate.`;
  }
  if (groupPaths(scene.groups).length > LIMITS.groups) return `A scene has at most ${count(LIMITS.groups)} groups.`;
  if (groupDepth(scene.groups) > LIMITS.groupDepth) return `Groups nest at most ${LIMITS.groupDepth} deep.`;
  return null;
}

/** How many agents the show can have, for as long as it lasts and with as many keyframes. */
export function mostAgents(scene: Scene): number {
  const keyframes = mainTrack(scene).keyframes.length;
  const byFrames = Math.floor(LIMITS.frames / frameCount(scene));
  return Math.min(LIMITS.agents, Math.floor(LIMITS.places / keyframes), byFrames);
}

/** `after`, unless it breaks a limit that `before` keeps: then nothing happens. */
export function withinLimits(before: Scene, after: Scene): Scene {
  return brokenLimit(after) === null || brokenLimit(before) !== null ? after : before;
}

export function clampCoordinate(value: number): number {
  return Math.max(-LIMITS.coordinate, Math.min(LIMITS.coordinate, value));
}

/** A name of at most `limit` characters, as the engine counts them. */
export function clipText(text: string, limit: number): string {
  const characters = [...text];
  return characters.length > limit ? characters.slice(0, limit).join("") : text;
}

function frameCount(scene: Scene): number {
  return Math.floor(durationOf(scene) * scene.frameRate + 1e-9) + 1;
}

function count(value: number): string {
  return value.toLocaleString("en-US");
}
