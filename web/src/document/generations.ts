import { type DBSchema, type IDBPDatabase, openDB } from "idb";
import { checksum } from "./checksum";
import { DATABASE } from "./database";

/** One saved scene as it lies in the database. */
interface Generation {
  /** Rises with every save; the higher is the newer. */
  readonly serial: number;
  /** When it was saved, milliseconds since 1970; those of early versions do not say. */
  readonly savedAt?: number;
  /** Of `text`. */
  readonly checksum: number;
  /** Scene JSON as the engine wrote it. */
  readonly text: string;
}

interface Database extends DBSchema {
  generations: { key: string; value: Generation };
}

export type GenerationStore = IDBPDatabase<Database>;

/** Two slots a place; each tab keeps its scene at a place of its own. */
function slotsOf(place: number): readonly [string, string] {
  return place === 0 ? ["a", "b"] : [`a${place}`, `b${place}`];
}

/** What was saved last. A newest save that does not verify is passed over for the one before, and said. */
export type Restored =
  | { readonly kind: "nothing" }
  | { readonly kind: "text"; readonly text: string; readonly isNewestDamaged: boolean }
  | { readonly kind: "damaged" };

/** Rejects, and never throws, where the browser refuses: some say so before there is anything to wait for. */
export async function openGenerations(name: string = DATABASE): Promise<GenerationStore> {
  return openDB<Database>(name, 1, {
    upgrade(database) {
      database.createObjectStore("generations");
    },
  });
}

/**
 * Writes over the older of the two generations, so that the newer one survives whatever happens on the way.
 *
 * Resolves when the transaction is complete and what lies there verifies.
 */
export async function writeGeneration(
  store: GenerationStore,
  text: string,
  place = 0,
  savedAt = Date.now(),
): Promise<void> {
  const [slotA, slotB] = slotsOf(place);
  const transaction = store.transaction("generations", "readwrite");
  // A refused write aborts the transaction; its own promise must have somebody to tell.
  transaction.done.catch(() => {});
  const [a, b] = await Promise.all([transaction.store.get(slotA), transaction.store.get(slotB)]);
  const [serialA, serialB] = [serialOf(a), serialOf(b)];
  const slot = serialA <= serialB ? slotA : slotB;
  const serial = Math.max(serialA, serialB, 0) + 1;
  await transaction.store.put({ serial, savedAt, checksum: checksum(text), text }, slot);
  await transaction.done;
  const written: unknown = await store.get("generations", slot);
  if (!isSound(written) || written.text !== text) throw new Error("what was saved does not read back");
}

/** The newest generation of a place that verifies. */
export async function readGenerations(store: GenerationStore, place = 0): Promise<Restored> {
  const found: unknown[] = await Promise.all(slotsOf(place).map((slot) => store.get("generations", slot)));
  const present = found.filter((generation) => generation !== undefined);
  const newest = present.filter(isSound).sort((p, q) => q.serial - p.serial)[0];
  if (!newest) return present.length > 0 ? { kind: "damaged" } : { kind: "nothing" };
  const isNewestDamaged = present.some((other) => !isSound(other) && claimedSerial(other) > newest.serial);
  return { kind: "text", text: newest.text, isNewestDamaged };
}

/** Places where something was kept, the latest first. */
export async function keptPlaces(store: GenerationStore): Promise<readonly number[]> {
  const latest = new Map<number, number>();
  for (const key of await store.getAllKeys("generations")) {
    const place = Number(key.slice(1));
    const generation: unknown = await store.get("generations", key);
    latest.set(place, Math.max(latest.get(place) ?? 0, savedAtOf(generation)));
  }
  return [...latest].sort(([placeA, a], [placeB, b]) => b - a || placeA - placeB).map(([place]) => place);
}

function savedAtOf(generation: unknown): number {
  return isSound(generation) ? (generation.savedAt ?? 0) : 0;
}

/** Zero for what does not verify: it is the first to be written over. */
function serialOf(generation: unknown): number {
  return isSound(generation) ? generation.serial : 0;
}

function isSound(value: unknown): value is Generation {
  if (typeof value !== "object" || value === null) return false;
  const { serial, checksum: claimed, text } = value as Partial<Generation>;
  return Number.isInteger(serial) && typeof text === "string" && checksum(text) === claimed;
}

/** What a damaged generation says of itself; without a number it counts as the newest. */
function claimedSerial(value: unknown): number {
  const serial = typeof value === "object" && value !== null ? (value as Partial<Generation>).serial : undefined;
  return typeof serial === "number" ? serial : Number.POSITIVE_INFINITY;
}
