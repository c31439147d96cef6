import { effect } from "@preact/signals";
import type { Autosave } from "./autosave";
import type { Scene } from "./scene";
import type { DocumentStore } from "./store";

/**
 * Saves every scene the document comes to, from the next change on; a gesture is saved when it ends.
 *
 * @param write the scene as text that can be opened again
 * @returns how to stop
 */
export function keepSaved(
  document: DocumentStore,
  autosave: Autosave,
  write: (scene: Scene) => Promise<string>,
): () => void {
  let last = document.scene.peek();
  return effect(() => {
    const scene = document.scene.value;
    if (document.isDragging.value || scene === last) return;
    last = scene;
    // The scene of this moment, not of the time of writing: what is said to be saved is what was shown.
    autosave.changed(() => write(scene));
  });
}
