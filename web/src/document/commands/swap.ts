import { chooseAgain, updateTrack } from "../edit";
import type { Command } from "../store";

/** Two agents take each other's places from a keyframe on: the ways that crossed before it no longer do. */
export function swapAgents(keyframe: number, a: number, b: number): Command {
  return {
    label: "Swap two agents",
    apply: (scene) => {
      const agents = scene.tracks[0]?.agents ?? [];
      if (a === b || !agents[a] || !agents[b]) return scene;
      const slots = Uint32Array.from(agents.keys(), (agent) => (agent === a ? b : agent === b ? a : agent));
      return takePlaces(keyframe, slots).apply(scene);
    },
  };
}

/** Whoever takes the place of an absent one is absent. */
function takers(absent: readonly number[], order: readonly number[]): readonly number[] {
  return absent.length === 0 ? absent : [...order.keys()].filter((agent) => absent.includes(order[agent] ?? -1));
}

/** @param slots by agent, whose place it takes from the keyframe on: each once, or nothing happens */
export function takePlaces(keyframe: number, slots: ArrayLike<number>): Command {
  const order = Array.from(slots);
  return {
    label: "Take other places",
    apply: (scene) =>
      updateTrack(scene, (track) => {
        const isBijection = order.length === track.agents.length && new Set(order).size === order.length;
        if (!isBijection || !track.keyframes[keyframe] || order.every((slot, agent) => slot === agent)) return track;
        if (order.some((slot) => !track.agents[slot])) return track;
        const keyframes = track.keyframes.map((was, index) =>
          index < keyframe
            ? was
            : { ...was, positions: was.positions.select(order), absent: takers(was.absent, order) },
        );
        const touched = [...track.segments.keys()].filter((segment) => segment >= keyframe - 1);
        return { ...track, keyframes, segments: chooseAgain(track.segments, touched) };
      }),
  };
}
