import { setMinimumDistance } from "../../document/commands/scene";
import { swapAgents } from "../../document/commands/swap";
import { setTransition } from "../../document/commands/transitions";
import { agentLabel } from "../../document/queries";
import { mainTrack, type Scene } from "../../document/scene";
import type { Command } from "../../document/store";
import { lengthWithUnit } from "../../document/units";
import type { SegmentReport, Suggestion } from "../../engine/api";

/** Something that may help where a transition does not keep the minimum distance; each is one undo entry. */
export interface NextStep {
  readonly label: string;
  readonly does:
    | { readonly kind: "command"; readonly command: Command }
    /** Everybody takes the place that is nearest, all in all. */
    | { readonly kind: "assign" }
    /** A keyframe at a time, scene seconds. */
    | { readonly kind: "keyframe"; readonly time: number };
}

/** What to try next, the likeliest first: avoidance where it is off, then what the engine proposes. */
export function nextSteps(scene: Scene, index: number, report: SegmentReport): NextStep[] {
  const segment = mainTrack(scene).segments[index];
  if (!segment) return [];
  if (!segment.avoidance) return [step("Avoid collisions", setTransition(index, { avoidance: true }))];
  return (report.suggestions ?? []).map((suggestion) => stepOf(scene, index, report, suggestion));
}

function stepOf(scene: Scene, index: number, { choice }: SegmentReport, suggestion: Suggestion): NextStep {
  switch (suggestion.kind) {
    case "swap": {
      const [a, b] = suggestion.agents;
      return step(`Swap ${agentLabel(scene, a)} and ${agentLabel(scene, b)}`, swapAgents(index + 1, a, b));
    }
    case "assign":
      return { label: "Nearest places", does: { kind: "assign" } };
    case "straight":
      return step("Straight guide", setTransition(index, { method: "linear" }));
    case "sharing":
      return step("More sharing", setTransition(index, { ...choice, sharing: suggestion.sharing }));
    case "distance": {
      const words = lengthWithUnit(suggestion.distance, scene.stage.units);
      return step(`Distance ${words}`, setMinimumDistance(suggestion.distance));
    }
    case "keyframe":
      return { label: "A keyframe between", does: { kind: "keyframe", time: suggestion.time } };
  }
}

function step(label: string, command: Command): NextStep {
  return { label, does: { kind: "command", command } };
}
