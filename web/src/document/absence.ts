import type { Track } from "./scene";

const NOBODY: readonly number[] = [];

/** Who is not there on the way of a transition, ascending: whoever is absent at both of its ends. */
export function goneIn({ keyframes }: Track, segment: number): readonly number[] {
  const [from, to] = [keyframes[segment]?.absent ?? NOBODY, keyframes[segment + 1]?.absent ?? NOBODY];
  return from.length === 0 || to.length === 0 ? NOBODY : from.filter((agent) => to.includes(agent));
}

/** Whether others are on the way before a keyframe than after it. */
export function changesCast(track: Track, keyframe: number): boolean {
  return goneIn(track, keyframe - 1).join() !== goneIn(track, keyframe).join();
}
