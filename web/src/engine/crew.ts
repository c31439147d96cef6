import { type ReadonlySignal, signal } from "@preact/signals";
import { WorkerLink } from "./link";

/** So many deaths in a row without a start between them, and the engine is given up. */
const DEATH_LIMIT = 4;

export type Health = "starting" | "ready" | "restarting" | "failed";

/**
 * Two workers from one compiled module: one plans, the other answers questions and stands by.
 * When the planner dies the other takes its place at once and a new one starts behind it.
 */
export interface Crew {
  readonly health: ReadonlySignal<Health>;
  /** Changes identity when the planning worker was replaced. */
  readonly planner: ReadonlySignal<WorkerLink | null>;
  /** The worker for questions; waits while one starts. */
  desk(): Promise<WorkerLink>;
  /** Ends the planning worker although it lives: it did not hear a cancel. */
  replacePlanner(): void;
}

export function createCrew(
  module: Promise<WebAssembly.Module>,
  onTrouble: (what: string, advice: string) => void,
): Crew {
  const health = signal<Health>("starting");
  const planner = signal<WorkerLink | null>(null);
  let desk: Promise<WorkerLink> = start();
  let deaths = 0;
  /** A planner that is ended on purpose is no trouble. */
  let isReplacing = false;

  async function start(): Promise<WorkerLink> {
    const link = new WorkerLink(await module);
    await link.started;
    deaths = 0;
    return link;
  }

  function watchDesk(waiting: Promise<WorkerLink>): void {
    waiting.then(
      (link) => {
        link.onDeath = () => {
          if (link !== planner.peek()) {
            renewDesk();
            return;
          }
          if (!isReplacing) onTrouble("The engine stopped and is starting again.", "Your scene is untouched.");
          bury();
        };
      },
      () => {
        if (waiting === desk) renewDesk();
      },
    );
  }

  function openDesk(): void {
    desk = start();
    watchDesk(desk);
  }

  function renewDesk(): void {
    deaths += 1;
    if (deaths <= DEATH_LIMIT) {
      openDesk();
      return;
    }
    health.value = "failed";
    onTrouble("The engine does not start.", "Reload the page to try again; your scene is kept.");
  }

  /** The desk becomes the planner; a new desk starts behind it. */
  async function promote(): Promise<void> {
    const coming = desk;
    const link = await coming.catch(() => null);
    if (coming !== desk || !link || link.isDead) {
      if (health.peek() !== "failed") void promote();
      return;
    }
    planner.value = link;
    health.value = "ready";
    openDesk();
  }

  function bury(): void {
    planner.value = null;
    health.value = "restarting";
    void promote();
  }

  watchDesk(desk);
  void promote();

  return {
    health,
    planner,
    desk: () => desk,
    replacePlanner() {
      isReplacing = true;
      planner.peek()?.terminate("the engine did not answer");
      isReplacing = false;
    },
  };
}
