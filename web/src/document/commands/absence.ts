import { reshapeKeyframe } from "../between";
import type { Command } from "../store";

/**
 * Some agents are not there while the others stand at a keyframe, or are again. Who comes or goes does so where a transition
 * ends: an in-between becomes such an end.
 */
export function setAbsent(keyframe: number, agents: ReadonlySet<number>, isAbsent: boolean): Command {
  return {
    label: isAbsent ? "Make absent here" : "Bring back here",
    apply: (scene) =>
      reshapeKeyframe(scene, keyframe, (was) => {
        const others = was.absent.filter((agent) => !agents.has(agent));
        const known = [...agents].filter((agent) => agent < was.positions.agentCount);
        const absent = isAbsent ? [...others, ...known].sort((a, b) => a - b) : others;
        return absent.join() === was.absent.join() ? was : { ...was, absent, between: 0 };
      }),
  };
}
