import type { Scene } from "./scene";

/** A scene one step away, with the words of the step that lies between. */
interface Step {
  readonly label: string;
  readonly series?: string | undefined;
  readonly scene: Scene;
}

/** The scene with what came before and what was taken back; the nearest step is the last of each list. Pure data. */
export interface History {
  readonly past: readonly Step[];
  readonly present: Scene;
  readonly future: readonly Step[];
}

/** Steps kept; scenes share what did not change, so a step costs one formation at most: 80 kB at 5,000 agents. */
export const KEPT_STEPS = 1000;

export function startHistory(scene: Scene): History {
  return { past: [], present: scene, future: [] };
}

/** The history after a step to `next`; the same history when nothing changed. A step of the series at work joins it. */
export function record(history: History, { label, series }: Omit<Step, "scene">, next: Scene): History {
  if (next === history.present) return history;
  const isContinued = series !== undefined && history.past.at(-1)?.series === series && history.future.length === 0;
  if (isContinued) return { ...history, present: next };
  const past = [...history.past.slice(1 - KEPT_STEPS), { label, series, scene: history.present }];
  return { past, present: next, future: [] };
}

/** One step back; the same history when there is none. */
export function stepBack(history: History): History {
  const step = history.past.at(-1);
  if (!step) return history;
  const undone = { label: step.label, scene: history.present };
  return { past: history.past.slice(0, -1), present: step.scene, future: [...history.future, undone] };
}

/** One step forward again; the same history when there is none. */
export function stepForward(history: History): History {
  const step = history.future.at(-1);
  if (!step) return history;
  const done = { label: step.label, scene: history.present };
  return { past: [...history.past, done], present: step.scene, future: history.future.slice(0, -1) };
}
