import { signal } from "@preact/signals";
import { expect, test } from "vitest";
import type { Autosave } from "./autosave";
import { setTitle } from "./commands/scene";
import { createDocument } from "./create-store";
import { emptyScene } from "./defaults";
import { keepSaved } from "./keep-saved";

function watched() {
  const document = createDocument(emptyScene());
  const saved: (() => Promise<string>)[] = [];
  const autosave: Autosave = {
    state: signal({ kind: "empty" }),
    words: signal(""),
    changed: (write) => saved.push(write),
    flush: async () => {},
    restore: async () => ({ kind: "nothing" }),
  };
  const stop = keepSaved(document, autosave, async (scene) => scene.title);
  return { document, saved, stop };
}

test("the scene one starts with is not saved over what is there", () => {
  expect(watched().saved).toHaveLength(0);
});

test("each change is saved as it was, undo included", async () => {
  const { document, saved, stop } = watched();
  document.perform(setTitle("One"));
  document.perform(setTitle("Two"));
  document.undo();
  expect(await Promise.all(saved.map((write) => write()))).toEqual(["One", "Two", "One"]);
  stop();
  document.redo();
  expect(saved).toHaveLength(3);
});

test("a gesture is saved once, when it ends, and not when it is given up", async () => {
  const { document, saved } = watched();
  const gesture = document.beginGesture();
  for (const title of ["O", "On", "One"]) gesture.preview(setTitle(title));
  expect(saved).toHaveLength(0);
  gesture.commit();
  expect(await Promise.all(saved.map((write) => write()))).toEqual(["One"]);
  const other = document.beginGesture();
  other.preview(setTitle("Two"));
  other.cancel();
  expect(saved).toHaveLength(1);
});
