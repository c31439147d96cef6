import { computed, type ReadonlySignal, signal } from "@preact/signals";
import { type GenerationStore, openGenerations, type Restored, readGenerations, writeGeneration } from "./generations";
import { holdPlace, type TabPlace } from "./tab-place";

/** Whether what the person sees is kept. `saved` is said only of exactly that, on disk and verified. */
export type SaveState =
  | { readonly kind: "empty" }
  | { readonly kind: "saving" }
  | { readonly kind: "saved" }
  | { readonly kind: "failed"; readonly why: "full" | "blocked" | "unwritable" };

export interface Autosave {
  readonly state: ReadonlySignal<SaveState>;
  /** The state in words for the top bar. */
  readonly words: ReadonlySignal<string>;
  /** The scene changed: `write` gives its text when it is time; only the last of many is asked. */
  changed(write: () => Promise<string>): void;
  /** What is pending is written now; resolves when it is done, or known to fail. */
  flush(): Promise<void>;
  /** What was saved last. Rejects never: storage that cannot be read is `nothing`, and the state says why. */
  restore(): Promise<Restored>;
}

export interface AutosaveParts {
  readonly open?: () => Promise<GenerationStore>;
  /** Takes this tab's place among those of the database. */
  readonly hold?: (store: GenerationStore) => Promise<TabPlace>;
  /** Calls back once after so many milliseconds; answers how to stop. */
  readonly after?: (milliseconds: number, call: () => void) => () => void;
}

/** Changes closer together are saved once, milliseconds. */
const PAUSE = 600;
/** A drag that never pauses is saved this often all the same, milliseconds. */
const LONGEST_WAIT = 5000;
/** What failed is tried again, milliseconds. */
const RETRY = 10_000;

const WORDS: Readonly<Record<"full" | "blocked" | "unwritable", string>> = {
  full: "Not saved: storage is full",
  blocked: "Not saved: the browser blocks storage",
  unwritable: "Not saved yet: trying again",
};

/**
 * Keeps the scene on this device in two generations, each tab for itself. Nothing is lost by a failure: it is said, and
 * tried again.
 */
export function createAutosave(parts: AutosaveParts = {}): Autosave {
  const { open = openGenerations, hold = holdPlace, after = afterTimeout } = parts;
  const state = signal<SaveState>({ kind: "empty" });
  let store: Promise<GenerationStore> | null = null;
  let place: Promise<TabPlace> | null = null;
  let pending: (() => Promise<string>) | null = null;
  let running: Promise<void> = Promise.resolve();
  let stopPause = () => {};
  let stopWait: (() => void) | null = null;

  /** One connection for all; a failed one is opened anew next time. */
  function database(): Promise<GenerationStore> {
    store ??= open().catch((error: unknown) => {
      store = null;
      throw new Blocked(error);
    });
    return store;
  }

  /** Taken once; what failed is tried again. */
  function placeIn(database: GenerationStore): Promise<TabPlace> {
    place ??= hold(database).catch((error: unknown) => {
      place = null;
      throw error;
    });
    return place;
  }

  async function writePending(): Promise<void> {
    const write = pending;
    if (!write) return;
    pending = null;
    try {
      const text = await write();
      const kept = await database();
      await writeGeneration(kept, text, (await placeIn(kept)).place);
      // Something newer came meanwhile: not saved yet.
      if (!pending) state.value = { kind: "saved" };
    } catch (error) {
      pending ??= write;
      // Whatever is wrong with the connection, such as storage cleared meanwhile, a new one may not have it.
      store = null;
      state.value = { kind: "failed", why: reasonOf(error) };
      schedule(RETRY);
    }
  }

  function flush(): Promise<void> {
    stopPause();
    stopWait?.();
    stopWait = null;
    // One write after another: two at once would take the same slot.
    running = running.then(writePending);
    return running;
  }

  function schedule(milliseconds: number): void {
    stopPause();
    stopPause = after(milliseconds, () => void flush());
  }

  return {
    state,
    words: computed(() => {
      const now = state.value;
      switch (now.kind) {
        case "empty":
          return "Nothing to save yet";
        case "saving":
          return "Saving…";
        case "saved":
          return "Saved on this device";
        case "failed":
          return WORDS[now.why];
      }
    }),
    changed(write) {
      pending = write;
      // A failure stays in sight until a write succeeds.
      if (state.peek().kind !== "failed") state.value = { kind: "saving" };
      schedule(PAUSE);
      stopWait ??= after(LONGEST_WAIT, () => void flush());
    },
    flush,
    async restore() {
      try {
        const kept = await database();
        const restored = await readGenerations(kept, (await placeIn(kept)).from);
        if (restored.kind === "text" && state.peek().kind === "empty") state.value = { kind: "saved" };
        return restored;
      } catch (error) {
        state.value = { kind: "failed", why: reasonOf(error) };
        return { kind: "nothing" };
      }
    },
  };
}

/** The database could not be opened at all. */
class Blocked extends Error {
  constructor(readonly reason: unknown) {
    super("the browser does not let the page store anything");
  }
}

function reasonOf(error: unknown): "full" | "blocked" | "unwritable" {
  const cause = error instanceof Blocked ? error.reason : error;
  if (cause instanceof Error && cause.name === "QuotaExceededError") return "full";
  return error instanceof Blocked ? "blocked" : "unwritable";
}

function afterTimeout(milliseconds: number, call: () => void): () => void {
  const timer = setTimeout(call, milliseconds);
  return () => clearTimeout(timer);
}
