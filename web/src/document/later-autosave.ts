import { computed, type ReadonlySignal, signal } from "@preact/signals";
import type { Autosave, SaveState } from "./autosave";
import { DATABASE } from "./database";

/** Words until there is something to keep, or where what keeps it could not be fetched. */
const NOTHING_YET = "Nothing to save yet";
const EMPTY: LaterState = { kind: "empty" };
const NOT_COME: LaterState = { kind: "failed", why: "unreachable" };
const UNREACHABLE = "Not saved yet: a part of the page did not load";

/** Autosave as the page holds it: what is asked of it meanwhile is done when it comes. */
export interface LaterAutosave extends Pick<Autosave, "words" | "changed" | "flush" | "restore"> {
  readonly state: ReadonlySignal<LaterState>;
}

/** As autosave has it, or that it did not come. */
export type LaterState = SaveState | { readonly kind: "failed"; readonly why: "unreachable" };

/** Fetched when there is something to keep, or something that was kept: a first visit has neither. */
export function laterAutosave(load: () => Promise<Autosave> = fetchAutosave): LaterAutosave {
  const ready = signal<Autosave | null>(null);
  const hasFailed = signal(false);
  let loading: Promise<Autosave> | null = null;

  function whenReady(): Promise<Autosave> {
    loading ??= load().then(
      (autosave) => {
        hasFailed.value = false;
        ready.value = autosave;
        return autosave;
      },
      (error: unknown) => {
        loading = null;
        hasFailed.value = true;
        throw error;
      },
    );
    return loading;
  }

  return {
    state: computed(() => ready.value?.state.value ?? (hasFailed.value ? NOT_COME : EMPTY)),
    words: computed(() => ready.value?.words.value ?? (hasFailed.value ? UNREACHABLE : NOTHING_YET)),
    changed(write) {
      whenReady().then(
        (autosave) => autosave.changed(write),
        // The words say it; the next change tries again.
        () => {},
      );
    },
    async flush() {
      await (await loading?.catch(() => null))?.flush();
    },
    async restore() {
      return (await isNothingKept()) ? { kind: "nothing" } : (await whenReady()).restore();
    },
  };
}

async function fetchAutosave(): Promise<Autosave> {
  return (await import("./autosave")).createAutosave();
}

/** Only where the browser says so: one that cannot tell, or refuses to, is asked for the scene itself. */
async function isNothingKept(): Promise<boolean> {
  try {
    return !(await indexedDB.databases()).some(({ name }) => name === DATABASE);
  } catch {
    return false;
  }
}
