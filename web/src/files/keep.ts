import { computed, effect } from "@preact/signals";
import type { LaterAutosave } from "../document/later-autosave";
import type { Scene } from "../document/scene";
import type { DocumentStore } from "../document/store";
import type { Engine } from "../engine/api";
import type { Messages } from "../panels/messages";

/** Why nothing is kept; what is only tried again goes without a word. */
const WHY = {
  full: "Storage is full.",
  blocked: "The browser blocks storage.",
  unreachable: "A part of the page did not load.",
  unwritable: null,
} as const;

/** Says it aloud when the scene cannot be kept, beside the words at its title, which a narrow page has no room for. */
export function sayWhenNotKept({ state }: Pick<LaterAutosave, "state">, messages: Messages): void {
  const why = computed(() => (state.value.kind === "failed" ? WHY[state.value.why] : null));
  effect(() => {
    if (!why.value) return;
    const text = `${why.value} Save it as a file, or share its link, to keep it.`;
    messages.say({ tone: "problem", title: "The scene is not kept on this device.", text });
  });
}

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
