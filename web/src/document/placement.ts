import { selectedAgents } from "./queries";
import { mainTrack, type Scene } from "./scene";
import type { Selection } from "./selection";

/** What Draw and Shape do at a keyframe: bring new agents, or place those the show has. */
export type Placement =
  | { readonly kind: "add" }
  | { readonly kind: "place"; readonly agents: readonly number[]; readonly reason: string };

/** The show's agents are made at its first keyframe; later ones place the selected agents, or else all of them. */
export function placementAt(scene: Scene, keyframe: number, selection: Selection): Placement {
  const all = mainTrack(scene).agents.length;
  if (keyframe === 0 || all === 0) return { kind: "add" };
  const selected = selection.kind === "tie" ? new Set<number>() : selectedAgents(scene, selection);
  if (selected.size === 0) {
    const reason = `Every keyframe has the same ${all} ${all === 1 ? "agent" : "agents"}; add agents at the first.`;
    return { kind: "place", agents: [...mainTrack(scene).agents.keys()], reason };
  }
  const agents = [...selected].sort((a, b) => a - b);
  const reason = `Places the ${agents.length} selected of ${all} agents; add agents at the first keyframe.`;
  return { kind: "place", agents, reason };
}
