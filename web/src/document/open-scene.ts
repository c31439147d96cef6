import { batch } from "@preact/signals";
import type { Scene } from "./scene";
import { NOTHING } from "./selection";
import type { Command, DocumentStore } from "./store";

/** A whole other scene (New, Open, Example); the old one stays one undo away. */
export function replaceScene(next: Scene, label: string): Command {
  return { label, apply: () => next };
}

/** Put a whole other scene on the page, at its first keyframe with nothing selected; undo brings the old one back. */
export function openScene(document: DocumentStore, scene: Scene, label: string): void {
  batch(() => {
    document.perform(replaceScene(scene, label));
    document.selection.value = NOTHING;
    document.activeKeyframe.value = 0;
  });
}
