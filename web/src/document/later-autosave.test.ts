import { signal } from "@preact/signals";
import { expect, test, vi } from "vitest";
import type { Autosave } from "./autosave";
import { laterAutosave } from "./later-autosave";

function autosave(): Autosave & { readonly written: string[] } {
  const written: string[] = [];
  return {
    written,
    state: signal({ kind: "saved" as const }),
    words: signal("Saved on this device"),
    changed: (write) => void write().then((text) => written.push(text)),
    flush: async () => {},
    restore: async () => ({ kind: "text", text: "kept", isNewestDamaged: false }),
  };
}

test("a first visit, with nothing kept, fetches nothing", async () => {
  vi.stubGlobal("indexedDB", { databases: async () => [{ name: "another" }] });
  const load = vi.fn();
  expect(await laterAutosave(load).restore()).toEqual({ kind: "nothing" });
  expect(load).not.toHaveBeenCalled();
});

test.each([
  ["keeps a scene", { databases: async () => [{ name: "eigenform" }] }],
  ["cannot say what it keeps", {}],
])("a browser that %s is asked for it", async (_, database) => {
  vi.stubGlobal("indexedDB", database);
  expect(await laterAutosave(async () => autosave()).restore()).toMatchObject({ kind: "text", text: "kept" });
});

test("what changes while the rest is on its way is kept when it comes", async () => {
  const real = autosave();
  const later = laterAutosave(async () => real);
  later.changed(async () => "first");
  expect(later.words.value).toBe("Nothing to save yet");
  await later.flush();
  await Promise.resolve();
  expect(real.written).toEqual(["first"]);
  expect(later.words.value).toBe("Saved on this device");
});

test("a part that does not load is said, and tried again at the next change", async () => {
  const real = autosave();
  const load = vi.fn<() => Promise<Autosave>>().mockRejectedValueOnce(new Error("offline")).mockResolvedValue(real);
  const later = laterAutosave(load);
  later.changed(async () => "lost");
  await vi.waitFor(() => expect(later.words.value).toMatch(/^Not saved yet/));
  later.changed(async () => "kept");
  await vi.waitFor(() => expect(real.written).toEqual(["kept"]));
});
