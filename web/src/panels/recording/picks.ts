import { DEFAULT_AGENT, DEFAULT_SEGMENT, emptyScene, keyframeAt } from "../../document/defaults";
import { Formation, type Point } from "../../document/formation";
import { clipText, LIMITS, SHORTEST_TRANSITION } from "../../document/limits";
import type { Scene } from "../../document/scene";
import type { Recording } from "../../engine/recording";

/** Centimeters, as the page snaps gestures: a link then holds the scene exactly. */
const GRID = 100;
/** Meters of stage around everything that was recorded. */
const MARGIN = 2;

/** Agents that are there in every picked frame, ascending. */
export function presentInAll(recording: Recording, frames: readonly number[]): number[] {
  const all = Array.from({ length: recording.agentCount }, (_, agent) => agent);
  return all.filter((agent) => frames.every((frame) => recording.isPresent(frame, agent)));
}

/** How far a recording is moved so that the middle of all it covers is the middle of the stage; whole meters. */
export function shiftOf(recording: Recording): Point {
  const bounds = recording.bounds();
  if (!bounds) return [0, 0];
  return [-Math.round((bounds.minX + bounds.maxX) / 2), -Math.round((bounds.minY + bounds.maxY) / 2)];
}

/** With one more frame picked, in the order of time; the same list when it is there already. */
export function withPick(frames: readonly number[], frame: number): readonly number[] {
  return frames.includes(frame) ? frames : [...frames, frame].sort((a, b) => a - b);
}

/** Why no scene can be made of these frames, in a sentence; null when one can. */
export function whyNot(recording: Recording, frames: readonly number[]): string | null {
  if (frames.length === 0) return "Pick at least one frame.";
  if (frames.length > LIMITS.keyframes) return `A scene has at most ${LIMITS.keyframes} keyframes.`;
  const near = frames.findIndex((frame, index) => {
    const before = frames[index - 1];
    return before !== undefined && recording.timeOf(frame - before) < SHORTEST_TRANSITION;
  });
  if (near > 0) return `Two picked frames are less than ${SHORTEST_TRANSITION} s apart.`;
  const count = presentInAll(recording, frames).length;
  if (count === 0) return "Nobody is there in all picked frames.";
  if (count > LIMITS.agents) return `A scene has at most ${LIMITS.agents} agents.`;
  return null;
}

/** A scene of the picked frames: a keyframe each, at its own time after the first, of those who are there in all of them. */
export function sceneOf(recording: Recording, frames: readonly number[], title: string): Scene {
  const agents = presentInAll(recording, frames);
  const [dx, dy] = shiftOf(recording);
  const snapped = (value: number) => Math.round(value * GRID) / GRID;
  const first = frames[0] ?? 0;
  const keyframes = frames.map((frame) => {
    const places = agents.map((agent): Point => {
      const [x, y] = recording.place(frame, agent);
      return [snapped(x + dx), snapped(y + dy)];
    });
    return keyframeAt(Math.round(recording.timeOf(frame - first) * 1000) / 1000, Formation.from(places));
  });
  const bounds = recording.bounds() ?? { minX: 0, maxX: 0, minY: 0, maxY: 0 };
  const scene = emptyScene();
  return {
    ...scene,
    title: clipText(title, LIMITS.title),
    frameRate: Math.min(LIMITS.frameRate.max, Math.max(LIMITS.frameRate.min, recording.frameRate)),
    stage: {
      ...scene.stage,
      width: Math.ceil(bounds.maxX - bounds.minX) + 2 * MARGIN,
      depth: Math.ceil(bounds.maxY - bounds.minY) + 2 * MARGIN,
    },
    tracks: [
      {
        agents: agents.map((agent) => ({
          ...DEFAULT_AGENT,
          name: clipText(recording.names[agent] ?? "", LIMITS.name),
        })),
        keyframes,
        segments: keyframes.slice(1).map(() => DEFAULT_SEGMENT),
      },
    ],
  };
}
