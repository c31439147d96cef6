import { batch } from "@preact/signals";
import { replaceScene } from "./commands/scene";
import type { Scene } from "./scene";
import { NOTHING } from "./selection";
import type { DocumentStore } from "./store";

/** Put a whole other scene on the page, at its first keyframe with nothing selected; undo brings the old one back. */
export function openScene(document: DocumentStore, scene: Scene, label: string): void {
  batch(() => {
    document.perform(replaceScene(scene, label));
    document.selection.value = NOTHING;
    document.activeKeyframe.value = 0;
  });
}
