import { computed, type ReadonlySignal } from "@preact/signals";
import type { Scene } from "./scene";
import type { Command, DocumentStore } from "./store";

/** Another way to look at a scene, and back. */
export interface Face {
  /** The scene as it is shown; the same object for the same scene. */
  shown(scene: Scene): Scene;
  /** What a changed showing of `before` means; `before` itself where nothing changed. */
  meant(shown: Scene, before: Scene): Scene;
}

/** The document as it is seen: what is done to what is shown is done to the scene. */
export function seenThrough(document: DocumentStore, face: ReadonlySignal<Face | null>): DocumentStore {
  function through(command: Command): Command {
    const now = face.peek();
    return now ? { ...command, apply: (scene) => now.meant(command.apply(now.shown(scene)), scene) } : command;
  }
  const seen = (scene: ReadonlySignal<Scene>) => computed(() => face.value?.shown(scene.value) ?? scene.value);
  return {
    ...document,
    scene: seen(document.scene),
    accepted: seen(document.accepted),
    perform: (command) => document.perform(through(command)),
    beginGesture() {
      const gesture = document.beginGesture();
      return { ...gesture, preview: (command) => gesture.preview(through(command)) };
    },
  };
}
