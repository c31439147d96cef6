import { type ReadonlySignal, signal } from "@preact/signals";
import type { ComparisonQuestion } from "../../../engine/api";
import type { Compared } from "../../../engine/comparison";

/** What is known of one way. */
export type Outcome =
  | { readonly kind: "waiting" }
  | { readonly kind: "done"; readonly compared: Compared }
  | { readonly kind: "failed"; readonly problem: string };

/** One way after the other of one scene, for as long as some are wanted whose numbers are not there. */
export interface Run {
  /** By question, see `outcomeOf`. */
  readonly known: ReadonlySignal<ReadonlyMap<string, Outcome>>;
  readonly isWorking: ReadonlySignal<boolean>;
  /** Wants these, and nothing else; what is known stays known. */
  want(questions: readonly ComparisonQuestion[]): void;
  /** Leaves the rest as it is. */
  stop(): void;
}

export interface RunParts {
  /** Null when it was stopped. */
  ask(question: ComparisonQuestion): Promise<Compared | null>;
  cancel(): void;
}

const WAITING: Outcome = { kind: "waiting" };

export function createRun({ ask, cancel }: RunParts): Run {
  const known = signal<ReadonlyMap<string, Outcome>>(new Map());
  const isWorking = signal(false);
  let wanted: readonly ComparisonQuestion[] = [];
  /** Whoever works for an earlier one has nothing more to say. */
  let generation = 0;

  async function work(): Promise<void> {
    const mine = generation;
    isWorking.value = true;
    for (;;) {
      const next = wanted.find((question) => !known.peek().has(keyOf(question)));
      if (!next) break;
      const outcome = await answered(next);
      if (mine !== generation) return;
      if (!outcome) break;
      known.value = new Map(known.peek()).set(keyOf(next), outcome);
    }
    isWorking.value = false;
  }

  async function answered(question: ComparisonQuestion): Promise<Outcome | null> {
    try {
      const compared = await ask(question);
      return compared && { kind: "done", compared };
    } catch (error) {
      return { kind: "failed", problem: error instanceof Error ? error.message : String(error) };
    }
  }

  return {
    known,
    isWorking,
    want(questions) {
      wanted = questions;
      if (!isWorking.peek()) void work();
    },
    stop() {
      generation += 1;
      if (isWorking.peek()) cancel();
      isWorking.value = false;
    },
  };
}

export function outcomeOf(known: ReadonlyMap<string, Outcome>, question: ComparisonQuestion): Outcome {
  return known.get(keyOf(question)) ?? WAITING;
}

function keyOf({ segment, way, cost, pace }: ComparisonQuestion): string {
  return `${segment} ${way} ${cost} ${pace}`;
}
