import { type ReadonlySignal, signal } from "@preact/signals";
import type { Branch } from "../../document/commands/propose";
import type { Scene } from "../../document/scene";
import type { Command, DocumentStore } from "../../document/store";
import type { GroupingWay, Metric } from "../../engine/api";

/** Groups by ties, or of those who keep their distances on the way to the next keyframe. */
export type Seeking =
  | GroupingWay
  | {
      readonly kind: "alike";
      /** −1 few groups … 1 many; 0: as many as the median likeness makes. */
      readonly amount: number;
      readonly metric: Metric;
    };

export interface ProposalParts {
  readonly document: DocumentStore;
  /** How many agents are to be grouped. */
  readonly agentCount: number;
  /** Null: another question took its place. */
  ask(scene: Scene, way: Seeking, tell: (progress: number) => void): Promise<readonly Branch[] | null>;
  /** Drops what is under way. */
  stop(): void;
  command(branches: readonly Branch[]): Command;
  announce(text: string): void;
  onProblem(error: unknown): void;
}

/** Groups on trial, in one gesture of the document; of several questions under way the latest counts. */
export interface Proposal {
  /** What is shown, in words; empty until something is. */
  readonly words: ReadonlySignal<string>;
  show(way: Seeking): void;
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
    parts.stop();
    gesture[how]();
  }

  return {
    words,
    show(way) {
      latest += 1;
      const question = latest;
      const tell = (progress: number) => {
        if (question === latest) words.value = `Looking for groups … ${Math.floor(progress * 100)} %`;
      };
      ask(start, way, tell).then(
        (branches) => {
          if (question !== latest || !branches) return;
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
