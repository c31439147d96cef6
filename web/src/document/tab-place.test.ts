import "fake-indexeddb/auto";
import { afterEach, beforeEach, expect, test } from "vitest";
import { type GenerationStore, openGenerations, writeGeneration } from "./generations";
import { holdPlace, type TabParts } from "./tab-place";

let store: GenerationStore;
let count = 0;
let taken: Set<string>;

beforeEach(async () => {
  count += 1;
  store = await openGenerations(`places ${count}`);
  taken = new Set();
});

afterEach(() => store.close());

/** A tab of one browser; what it remembers can be handed to a later one. */
function tab(remembered = new Map<string, string>()) {
  const held: string[] = [];
  const request = (name: string, options: LockOptions, call: (lock: Lock | null) => unknown): Promise<unknown> => {
    if (taken.has(name)) {
      // Who waits has waited long enough.
      return options.signal ? Promise.reject(new DOMException("", "TimeoutError")) : Promise.resolve(call(null));
    }
    taken.add(name);
    held.push(name);
    return Promise.resolve(call({ name, mode: "exclusive" }));
  };
  const parts: TabParts = {
    locks: { request } as TabParts["locks"],
    memory: { getItem: (key) => remembered.get(key) ?? null, setItem: (key, value) => remembered.set(key, value) },
  };
  return {
    remembered,
    hold: () => holdPlace(store, parts),
    close() {
      for (const name of held) taken.delete(name);
    },
  };
}

test("a first tab takes the first place, a second another and begins with a copy", async () => {
  expect(await tab().hold()).toEqual({ place: 0, from: 0 });
  await writeGeneration(store, "one");
  expect(await tab().hold()).toEqual({ place: 1, from: 0 });
});

test("a tab that is reloaded finds its own place, however new the others are", async () => {
  const [first, second] = [tab(), tab()];
  await first.hold();
  await second.hold();
  await writeGeneration(store, "other", 1, 5);
  await writeGeneration(store, "mine", 0, 4);
  first.close();
  second.close();
  expect(await tab(first.remembered).hold()).toEqual({ place: 0, from: 0 });
  expect(await tab(second.remembered).hold()).toEqual({ place: 1, from: 1 });
});

test("a copy of a tab that is still there gets a place of its own", async () => {
  const first = tab();
  await first.hold();
  expect((await tab(new Map(first.remembered)).hold()).place).toBe(1);
});

test("after all tabs are closed the scene that was kept last comes back, then the one before", async () => {
  await writeGeneration(store, "older", 0, 1);
  await writeGeneration(store, "newer", 1, 2);
  expect(await tab().hold()).toEqual({ place: 1, from: 1 });
  expect(await tab().hold()).toEqual({ place: 0, from: 0 });
  expect(await tab().hold()).toEqual({ place: 2, from: 1 });
});

test("a browser without locks or memory keeps to one place", async () => {
  const parts: TabParts = { locks: undefined, memory: undefined };
  expect(await holdPlace(store, parts)).toEqual({ place: 0, from: 0 });
});
