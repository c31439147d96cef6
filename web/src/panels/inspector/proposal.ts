import { type ReadonlySignal, signal } from "@preact/signals";
import type { Branch } from "../../document/commands/propose";
import type { Scene } from "../../document/scene";
import type { Command, DocumentStore } from "../../document/store";
import type { GroupingWay } from "../../engine/api";

export interface ProposalParts {
  readonly document: DocumentStore;
  /** How many agents are to be grouped. */
  readonly agentCount: number;
  ask(scene: Scene, way: GroupingWay): Promise<readonly Branch[]>;
  command(branches: readonly Branch[]): Command;
  announce(text: string): void;
  onProblem(error: unknown): void;
}

/** Groups on trial, in one gesture of the document; of several questions under way the latest counts. */
export interface Proposal {
  /** What is shown, in words; empty until something is. */
  readonly words: ReadonlySignal<string>;
  show(way: GroupingWay): void;
  accept(): void;
  cancel(): void;
}

/** Begins a trial with the scene as it is; the proposals start from it, however many are looked at. */
export function createProposal(parts: ProposalParts): Proposal {
  const { document, agentCount, ask, command } = parts;
  const start = document.scene.peek();
  const gesture = document.beginGesture();
  const words = signal("");
  let latest = 0;

  function end(how: "commit" | "cancel"): void {
    latest = -1;
    gesture[how]();
  }

  return {
    words,
    show(way) {
      latest += 1;
      const question = latest;
      ask(start, way).then(
        (branches) => {
          if (question !== latest) return;
          gesture.preview(command(branches));
          words.value = proposedWords(branches, agentCount);
          parts.announce(words.value);
        },
        (error: unknown) => {
          if (question === latest) parts.onProblem(error);
        },
      );
    },
    accept: () => end("commit"),
    cancel: () => end("cancel"),
  };
}

/** `3 groups`, `6 groups in 2`, `2 groups, 4 agents by themselves`, `No groups`. */
export function proposedWords(branches: readonly Branch[], agentCount: number): string {
  if (branches.length === 0) return "No groups";
  const leaves = branches.flatMap(leavesOf);
  const grouped = leaves.reduce((sum, leaf) => sum + leaf.members.length, 0);
  const alone = agentCount - grouped;
  const groups = `${leaves.length} ${leaves.length === 1 ? "group" : "groups"}`;
  const within = leaves.length > branches.length ? ` in ${branches.length}` : "";
  const beside = alone > 0 ? `, ${alone} ${alone === 1 ? "agent" : "agents"} in none` : "";
  return groups + within + beside;
}

function leavesOf(branch: Branch): readonly Branch[] {
  return branch.children.length > 0 ? branch.children.flatMap(leavesOf) : [branch];
}
