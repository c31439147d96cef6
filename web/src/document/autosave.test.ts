import "fake-indexeddb/auto";
import { afterEach, beforeEach, expect, test } from "vitest";
import { type Autosave, createAutosave } from "./autosave";
import { checksum } from "./checksum";
import { type GenerationStore, openGenerations, readGenerations, writeGeneration } from "./generations";

let store: GenerationStore;
let count = 0;

beforeEach(async () => {
  count += 1;
  store = await openGenerations(`test ${count}`);
});

afterEach(() => store.close());

/** Time that passes only when told to. */
function clock() {
  let now = 0;
  let waiting: { at: number; call: () => void }[] = [];
  return {
    after(milliseconds: number, call: () => void) {
      const entry = { at: now + milliseconds, call };
      waiting.push(entry);
      return () => {
        waiting = waiting.filter((other) => other !== entry);
      };
    },
    pass(milliseconds: number) {
      now += milliseconds;
      const due = waiting.filter(({ at }) => at <= now);
      waiting = waiting.filter(({ at }) => at > now);
      for (const { call } of due) call();
    },
  };
}

function autosaveOn(open: () => Promise<GenerationStore> = async () => store) {
  const time = clock();
  return { time, save: createAutosave({ open, after: time.after }) };
}

/** Until what is under way is written. */
const settled = (save: Autosave) => save.flush();

test("the checksum is the one of zip", () => {
  expect(checksum("123456789")).toBe(0xcbf43926);
  expect(checksum("")).toBe(0);
});

test("what was saved last comes back", async () => {
  for (const text of ["one", "two", "three"]) await writeGeneration(store, text);
  expect(await readGenerations(store)).toEqual({ kind: "text", text: "three", isNewestDamaged: false });
});

test("a damaged newest save gives way to the one before, and says so", async () => {
  for (const text of ["one", "two", "three"]) await writeGeneration(store, text);
  const newest = await store.get("generations", "a");
  await store.put("generations", { serial: 3, checksum: newest?.checksum ?? 0, text: "thrxe" }, "a");
  expect(await readGenerations(store)).toEqual({ kind: "text", text: "two", isNewestDamaged: true });
});

test("the next save goes over the damaged one and leaves the good one alone", async () => {
  for (const text of ["one", "two", "three"]) await writeGeneration(store, text);
  await store.put("generations", { serial: 3, checksum: 0, text: "thrxe" }, "a");
  await writeGeneration(store, "four");
  expect((await store.get("generations", "b"))?.text).toBe("two");
  expect(await readGenerations(store)).toEqual({ kind: "text", text: "four", isNewestDamaged: false });
});

test("two damaged saves are said, not opened", async () => {
  await store.put("generations", { serial: 1, checksum: 0, text: "x" }, "a");
  await store.put("generations", { serial: 2, checksum: 0, text: "y" }, "b");
  expect(await readGenerations(store)).toEqual({ kind: "damaged" });
});

test("an empty storage has nothing to bring back", async () => {
  const { save } = autosaveOn();
  expect(await save.restore()).toEqual({ kind: "nothing" });
  expect(save.words.value).toBe("Nothing to save yet");
});

test("saved is said only when it lies on disk", async () => {
  const { save, time } = autosaveOn();
  save.changed(async () => "a scene");
  expect(save.words.value).toBe("Saving…");
  time.pass(599);
  expect(await readGenerations(store)).toEqual({ kind: "nothing" });
  time.pass(1);
  expect(save.words.value).toBe("Saving…");
  await settled(save);
  expect(save.words.value).toBe("Saved on this device");
  expect(await readGenerations(store)).toMatchObject({ text: "a scene" });
});

test("of many changes in a row the last is written, once", async () => {
  const { save, time } = autosaveOn();
  let written = 0;
  for (let i = 0; i < 20; i += 1) {
    time.pass(100);
    save.changed(async () => {
      written += 1;
      return `scene ${i}`;
    });
  }
  time.pass(600);
  await settled(save);
  expect(written).toBe(1);
  expect(await readGenerations(store)).toMatchObject({ text: "scene 19" });
});

test("changes without a pause are saved all the same", async () => {
  const { save, time } = autosaveOn();
  for (let i = 0; i < 60; i += 1) {
    save.changed(async () => `scene ${i}`);
    time.pass(100);
  }
  await new Promise((resolve) => setTimeout(resolve, 20));
  expect((await readGenerations(store)).kind).toBe("text");
});

test("a change while another is written is not called saved", async () => {
  const { save } = autosaveOn();
  save.changed(async () => {
    save.changed(async () => "newer");
    return "older";
  });
  await save.flush();
  expect(save.words.value).toBe("Saving…");
  await save.flush();
  expect(save.words.value).toBe("Saved on this device");
  expect(await readGenerations(store)).toMatchObject({ text: "newer" });
});

test("full storage is said, the last save stays, and it is tried again", async () => {
  await writeGeneration(store, "before");
  let isFull = true;
  const limited = new Proxy(store, {
    get(target, name) {
      if (name === "transaction" && isFull) {
        return () => {
          throw new DOMException("no room", "QuotaExceededError");
        };
      }
      const value: unknown = Reflect.get(target, name);
      return typeof value === "function" ? value.bind(target) : value;
    },
  });
  const { save, time } = autosaveOn(async () => limited);
  save.changed(async () => "after");
  await save.flush();
  expect(save.words.value).toBe("Not saved: storage is full");
  expect(await readGenerations(store)).toMatchObject({ text: "before" });
  save.changed(async () => "later");
  expect(save.words.value).toBe("Not saved: storage is full");
  isFull = false;
  time.pass(600);
  await settled(save);
  expect(save.words.value).toBe("Saved on this device");
  expect(await readGenerations(store)).toMatchObject({ text: "later" });
});

test("what failed is tried again by itself", async () => {
  let tries = 0;
  const { save, time } = autosaveOn(async () => {
    tries += 1;
    if (tries === 1) throw new DOMException("not allowed", "SecurityError");
    return store;
  });
  save.changed(async () => "a scene");
  await save.flush();
  expect(save.words.value).toBe("Not saved: the browser blocks storage");
  time.pass(10_000);
  await settled(save);
  expect(save.words.value).toBe("Saved on this device");
});

test("blocked storage is said when the page opens, and nothing breaks", async () => {
  const { save } = autosaveOn(async () => {
    throw new DOMException("not allowed", "SecurityError");
  });
  expect(await save.restore()).toEqual({ kind: "nothing" });
  expect(save.words.value).toBe("Not saved: the browser blocks storage");
});

test("a scene that cannot be written down is not called saved", async () => {
  const { save } = autosaveOn();
  save.changed(async () => {
    throw new Error("the engine is away");
  });
  await save.flush();
  expect(save.state.value.kind).toBe("failed");
});
