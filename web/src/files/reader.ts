import { type Engine, EngineError, type EngineProblem, type Opened } from "../engine/api";
import { type Messages, OPENING } from "../panels/messages";

/** Text from outside, read through the engine; a refusal is said. */
export interface Reader {
  /** Null after saying why not. */
  read(text: string, name: string): Promise<Opened | null>;
  refuse(name: string, problem: EngineProblem): void;
}

/** The problem as a person reads it, what and where: a sentence, of which the engine says the words only. */
export function sentence({ what, where }: EngineProblem): string {
  const said = what.charAt(0).toUpperCase() + what.slice(1).replace(/\.$/, "");
  return where ? `${said} (${where}).` : `${said}.`;
}

export function problemFrom(error: unknown): EngineProblem {
  if (error instanceof EngineError) return error.problem;
  return { code: "unexpected", what: error instanceof Error ? error.message : String(error), where: "" };
}

export function createReader(engine: Pick<Engine, "open">, messages: Pick<Messages, "say">): Reader {
  function refuse(name: string, problem: EngineProblem): void {
    messages.say({
      tone: "problem",
      about: OPENING,
      title: `${name} was not opened.`,
      text: `${sentence(problem)} Your scene is unchanged.`,
    });
  }

  return {
    refuse,
    async read(text, name) {
      try {
        return await engine.open(text);
      } catch (error) {
        refuse(name, problemFrom(error));
        return null;
      }
    },
  };
}
