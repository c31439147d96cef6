import { useEffect, useState } from "preact/hooks";
import { EngineError, type EngineProblem } from "../../engine/api";

/** An answer that is on its way, there, or will not come. */
export type Answer<Value> =
  | { readonly kind: "waiting" }
  | { readonly kind: "here"; readonly value: Value }
  | { readonly kind: "refused"; readonly problem: EngineProblem };

/** Asks once, when the dialog opens. */
export function useAnswer<Value>(ask: () => Promise<Value>): Answer<Value> {
  const [answer, setAnswer] = useState<Answer<Value>>({ kind: "waiting" });
  useEffect(() => {
    let isWanted = true;
    ask().then(
      (value) => isWanted && setAnswer({ kind: "here", value }),
      (error: unknown) => isWanted && setAnswer({ kind: "refused", problem: problemOf(error) }),
    );
    return () => {
      isWanted = false;
    };
  }, []);
  return answer;
}

/** What is known of what went wrong. */
export function problemOf(error: unknown): EngineProblem {
  if (error instanceof EngineError) return error.problem;
  return { code: "unexpected", what: error instanceof Error ? error.message : String(error), where: "" };
}
