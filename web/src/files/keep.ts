import { effect } from "@preact/signals";
import type { LaterAutosave } from "../document/later-autosave";
import type { Scene } from "../document/scene";
import type { DocumentStore } from "../document/store";
import type { Engine } from "../engine/api";

/** Keeps the scene on this device whenever it changes, from now on. `settled` itself need not be kept. */
export function keepScene(document: DocumentStore, autosave: LaterAutosave, engine: Engine, settled: Scene): void {
  let last = settled;
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
