import type { Keyframe, Track } from "./scene";

const NOBODY: readonly number[] = [];

/** Who is not there on the way of a transition, ascending: whoever is absent at both of its ends. */
export function goneIn({ keyframes }: Track, segment: number): readonly number[] {
  return goneOnTheWay(keyframes[segment], keyframes[segment + 1]);
}

/** The same from any keyframe to another. */
export function goneOnTheWay(source: Keyframe | undefined, target: Keyframe | undefined): readonly number[] {
  const [from, to] = [source?.absent ?? NOBODY, target?.absent ?? NOBODY];
  return from.length === 0 || to.length === 0 ? NOBODY : from.filter((agent) => to.includes(agent));
}

/** Who stands at a keyframe, ascending. */
export function presentAt({ agents, keyframes }: Track, keyframe: number): readonly number[] {
  return others(agents.length, keyframes[keyframe]?.absent ?? NOBODY);
}

/** Who is on the way of a transition, ascending. */
export function walkersOf(track: Track, segment: number): readonly number[] {
  return others(track.agents.length, goneIn(track, segment));
}

/** Whether others are on the way before a keyframe than after it. */
export function changesCast(track: Track, keyframe: number): boolean {
  return goneIn(track, keyframe - 1).join() !== goneIn(track, keyframe).join();
}

function others(agentCount: number, gone: readonly number[]): readonly number[] {
  const isGone = new Set(gone);
  return Array.from({ length: agentCount }, (_, agent) => agent).filter((agent) => !isGone.has(agent));
}
