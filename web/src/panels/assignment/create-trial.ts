import { type ReadonlySignal, signal } from "@preact/signals";
import type { AssignmentSpec, Scene } from "../../document/scene";
import { type AssignmentQuestion, EngineError, type FoundPlaces } from "../../engine/api";
import { noWayWords } from "../no-way";

/** Who would go where, on trial: the scene stays as it is until the answer is accepted. */
export interface AssignmentTrial {
  readonly question: ReadonlySignal<AssignmentQuestion>;
  /** Who would take which place; null until there is an answer. */
  readonly found: ReadonlySignal<FoundPlaces | null>;
  /** 0..1; null when nothing is under way. */
  readonly progress: ReadonlySignal<number | null>;
  /** Why there is no answer, in a sentence. */
  readonly problem: ReadonlySignal<string | null>;
  /** Whose lock the last one took the place of, and who has that place now; null when it took nobody's. */
  readonly gaveWay: ReadonlySignal<{ readonly agent: number; readonly to: number } | null>;
  setRecipe(change: Partial<Omit<AssignmentSpec, "locks">>): void;
  setWay(change: Partial<Pick<AssignmentQuestion, "isFlipped" | "isPredicted" | "rest">>): void;
  /** This agent takes this place, whatever it costs; who had one of them locked has not any more. */
  lock(agent: number, slot: number): void;
  unlock(agent: number): void;
  /** Asks with the scene as it is now. */
  ask(): void;
  /** Leaves the last answer as it is. */
  stop(): void;
}

export interface TrialParts {
  scene(): Scene;
  find(scene: Scene, question: AssignmentQuestion, tell: (progress: number) => void): Promise<FoundPlaces | null>;
  stop(): void;
}

/** Of several questions under way the latest counts. */
export function createTrial(segment: number, recipe: AssignmentSpec, parts: TrialParts): AssignmentTrial {
  const question = signal<AssignmentQuestion>({ segment, recipe, isFlipped: false, isPredicted: false });
  const found = signal<FoundPlaces | null>(null);
  const progress = signal<number | null>(null);
  const problem = signal<string | null>(null);
  const gaveWay = signal<{ readonly agent: number; readonly to: number } | null>(null);
  let latest = 0;

  async function ask(): Promise<void> {
    latest += 1;
    const mine = latest;
    const isLatest = () => mine === latest;
    progress.value = 0;
    problem.value = null;
    try {
      const answer = await parts.find(parts.scene(), question.peek(), (at) => {
        if (isLatest()) progress.value = at;
      });
      if (isLatest() && answer) found.value = answer;
    } catch (error) {
      if (isLatest()) problem.value = problemWords(error, parts.scene());
    }
    if (isLatest()) progress.value = null;
  }

  function change(next: Partial<AssignmentQuestion>): void {
    question.value = { ...question.peek(), ...next };
    void ask();
  }

  function setLocks(locks: AssignmentSpec["locks"]): void {
    const isPredicted = question.peek().isPredicted && locks.length > 0;
    change({ recipe: { ...question.peek().recipe, locks }, isPredicted });
  }

  const locks = () => question.peek().recipe.locks;
  return {
    question,
    found,
    progress,
    problem,
    gaveWay,
    setRecipe: (part) => change({ recipe: { ...question.peek().recipe, ...part } }),
    setWay: change,
    lock(agent, slot) {
      const former = locks().find((lock) => lock[0] !== agent && lock[1] === slot);
      gaveWay.value = former ? { agent: former[0], to: agent } : null;
      setLocks([...locks().filter((lock) => lock[0] !== agent && lock[1] !== slot), [agent, slot]]);
    },
    unlock(agent) {
      gaveWay.value = null;
      setLocks(locks().filter((lock) => lock[0] !== agent));
    },
    ask: () => void ask(),
    stop() {
      latest += 1;
      progress.value = null;
      parts.stop();
    },
  };
}

function problemWords(error: unknown, scene: Scene): string {
  if (error instanceof EngineError && error.problem.noWay) return noWayWords(scene, error.problem.noWay);
  return error instanceof Error ? error.message : String(error);
}

/** The one that is open, for what is drawn over the stage. */
export const openTrial = signal<AssignmentTrial | null>(null);
