import { effect } from "@preact/signals";
import type { Autosave } from "../document/autosave";
import type { Scene } from "../document/scene";
import type { DocumentStore } from "../document/store";
import type { Engine } from "../engine/api";

/** Keeps every change of the scene on this device, from now on; what is on the page already is not a change. */
export function keepScene(document: DocumentStore, autosave: Autosave, engine: Engine): void {
  let last: Scene = document.scene.peek();
  effect(() => {
    const scene = document.scene.value;
    if (scene === last || document.isDragging.value) return;
    last = scene;
    // This scene and not the one at the time of writing: that may be a drag that is given up.
    autosave.changed(() => engine.writeScene(scene));
  });
  // A page that is hidden may never come back.
  addEventListener("pagehide", () => void autosave.flush());
  globalThis.document.addEventListener("visibilitychange", () => {
    if (globalThis.document.visibilityState === "hidden") void autosave.flush();
  });
}
