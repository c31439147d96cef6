import { type GenerationStore, keptPlaces } from "./generations";

/** Where a tab keeps its scene, and where the scene lies that it begins with. */
export interface TabPlace {
  readonly place: number;
  readonly from: number;
}

/** What tells tabs apart: locks that last as long as a page, and a memory that outlives a reload of it. */
export interface TabParts {
  readonly locks: Pick<LockManager, "request"> | undefined;
  readonly memory: Pick<Storage, "getItem" | "setItem"> | undefined;
}

const MEMORY = "eigenform place";

/** A page that is reloaded may come before its former self has let go, milliseconds. */
const PATIENCE = 400;

/** More tabs at once share the last place. */
const MOST_PLACES = 64;

/**
 * Takes a place that no other tab holds, until the page goes: after a reload its own, else the one where a scene was kept
 * last, else an empty one. A tab without a scene of its own begins with a copy of the newest there is.
 */
export async function holdPlace(store: GenerationStore, parts: TabParts = ofThePage()): Promise<TabPlace> {
  const kept = await keptPlaces(store);
  const newest = kept[0] ?? 0;
  const remembered = readMemory(parts);
  const empty = Array.from({ length: MOST_PLACES }, (_, place) => place).filter((place) => !kept.includes(place));
  for (const place of new Set([...(remembered === null ? [] : [remembered]), ...kept, ...empty])) {
    if (!(await isOurs(parts, place, place === remembered))) continue;
    writeMemory(parts, place);
    return { place, from: kept.includes(place) ? place : newest };
  }
  return { place: MOST_PLACES - 1, from: newest };
}

/** Whether the place is this page's now; without locks every tab has the first. */
function isOurs({ locks }: TabParts, place: number, isAwaited: boolean): Promise<boolean> {
  if (!locks) return Promise.resolve(true);
  return new Promise((resolve) => {
    const options = isAwaited ? { signal: AbortSignal.timeout(PATIENCE) } : { ifAvailable: true };
    const held = locks.request(`${MEMORY} ${place}`, options, (lock) => {
      resolve(lock !== null);
      // Held for as long as the page is there.
      return lock === null ? undefined : new Promise<void>(() => {});
    });
    // Where locks are refused, scenes are kept as by a browser that has none.
    held.catch((error: unknown) => resolve(!isOver(error)));
  });
}

/** Whether another held the place for as long as it was waited for. */
function isOver(error: unknown): boolean {
  return error instanceof DOMException && (error.name === "TimeoutError" || error.name === "AbortError");
}

function readMemory({ memory }: TabParts): number | null {
  try {
    const place = Number(memory?.getItem(MEMORY) ?? Number.NaN);
    return Number.isInteger(place) && place >= 0 && place < MOST_PLACES ? place : null;
  } catch {
    return null;
  }
}

function writeMemory({ memory }: TabParts, place: number): void {
  try {
    memory?.setItem(MEMORY, String(place));
  } catch {
    // A full or forbidden memory costs a reload its own place and nothing else.
  }
}

function ofThePage(): TabParts {
  return { locks: globalThis.navigator?.locks, memory: storageOfThePage() };
}

/** Some browsers refuse the very word. */
function storageOfThePage(): Storage | undefined {
  try {
    return globalThis.sessionStorage;
  } catch {
    return undefined;
  }
}
