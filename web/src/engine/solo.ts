import { type ReadonlySignal, signal } from "@preact/signals";
import { EngineError } from "./api";
import { WorkerGone, WorkerLink } from "./link";
import { workshopModule } from "./module";
import type { CallName, Calls } from "./protocol";

/** So many deaths and it is not started again: what it was asked takes the engine down. */
const DEATH_LIMIT = 2;

/** One more engine, for a view that asks much and is closed again: nobody else waits for its answers. */
export interface Solo {
  /** Null while it starts. As a planner's crew it has this one worker. */
  readonly planner: ReadonlySignal<WorkerLink | null>;
  ask<Name extends CallName>(
    name: Name,
    askOf: (link: WorkerLink) => Calls[Name]["ask"],
  ): Promise<Calls[Name]["answer"]>;
  replacePlanner(): void;
  /** Ends the worker and whatever it was at. */
  end(): void;
}

export function createSolo(): Solo {
  const planner = signal<WorkerLink | null>(null);
  let isEnded = false;
  let deaths = 0;
  let coming = begin();

  /** Whoever asks hears of a start that fails; until then nobody does. */
  function begin(): Promise<WorkerLink> {
    const started = start();
    started.catch(() => {});
    return started;
  }

  async function start(): Promise<WorkerLink> {
    const link = new WorkerLink(await workshopModule(), "workshop");
    link.onDeath = () => {
      planner.value = null;
      deaths += 1;
      if (!isEnded && deaths <= DEATH_LIMIT) coming = begin();
    };
    await link.started;
    if (isEnded) link.terminate("its view was closed");
    else planner.value = link;
    return link;
  }

  return {
    planner,
    async ask(name, askOf) {
      try {
        const link = await coming;
        return await link.call(name, askOf(link)).answer;
      } catch (error) {
        if (!(error instanceof WorkerGone)) throw error;
        const what = "The engine stopped while it worked on this.";
        throw new EngineError({ code: "engine-stopped", what, where: "" });
      }
    },
    replacePlanner: () => planner.peek()?.terminate("the engine did not answer"),
    end() {
      isEnded = true;
      planner.peek()?.terminate("its view was closed");
    },
  };
}
