import { useEffect, useMemo, useState } from "preact/hooks";
import { EngineError, type EngineProblem } from "../../engine/api";

/** The last answer there is; while a newer one is on its way, the one before it. */
export interface Latest<Value> {
  readonly value: Value | null;
  readonly isWaiting: boolean;
  readonly problem: EngineProblem | null;
}

/** Asks one thing at a time; of what is wanted meanwhile only the newest is asked. */
export function createQueue<Value>(tell: (latest: Latest<Value>) => void): { want(ask: () => Promise<Value>): void } {
  let wanted: (() => Promise<Value>) | null = null;
  let isAsking = false;
  let value: Value | null = null;

  async function ask(): Promise<void> {
    isAsking = true;
    while (wanted) {
      const next = wanted;
      wanted = null;
      tell({ value, isWaiting: true, problem: null });
      try {
        value = await next();
        tell({ value, isWaiting: wanted !== null, problem: null });
      } catch (error) {
        value = null;
        tell({ value, isWaiting: wanted !== null, problem: problemOf(error) });
      }
    }
    isAsking = false;
  }

  return {
    want(next) {
      wanted = next;
      if (!isAsking) void ask();
    },
  };
}

function problemOf(error: unknown): EngineProblem {
  if (error instanceof EngineError) return error.problem;
  return { code: "unexpected", what: error instanceof Error ? error.message : String(error), where: "" };
}

/** The newest answer to a question that is asked anew whenever one of `inputs` is another object. */
export function useLatest<Value>(inputs: readonly unknown[], ask: () => Promise<Value>): Latest<Value> {
  const [latest, setLatest] = useState<Latest<Value>>({ value: null, isWaiting: true, problem: null });
  const queue = useMemo(() => createQueue<Value>(setLatest), []);
  useEffect(() => queue.want(ask), inputs);
  return latest;
}
