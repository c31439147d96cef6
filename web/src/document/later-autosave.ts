import { computed, signal } from "@preact/signals";
import type { Autosave, SaveState } from "./autosave";
import { DATABASE } from "./database";

/** Words until there is something to keep, or where what keeps it could not be fetched. */
const NOTHING_YET = "Nothing to save yet";
const EMPTY: SaveState = { kind: "empty" };
const UNREACHABLE = "Not saved yet: a part of the page did not load";

/** Autosave as the page holds it: what is asked of it meanwhile is done when it comes. */
export type LaterAutosave = Pick<Autosave, "state" | "words" | "changed" | "flush" | "restore">;

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
    state: computed(() => ready.value?.state.value ?? EMPTY),
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
