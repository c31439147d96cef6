import { computed } from "@preact/signals";
import { allAgents } from "../document/queries";
import { mainTrack, type Scene } from "../document/scene";
import type { ActionParts, Doings } from "./doing";

/** What a person can do before anything is selected. */
export function historyActions({ document, messages, view }: ActionParts): Doings<"undo" | "redo" | "select-all"> {
  /** Another scene is looked at as a whole, as when it was opened; an edit of this one leaves the view where it is. */
  function step(by: () => void): void {
    const before = document.scene.peek();
    by();
    if (isAnother(before, document.scene.peek())) view.fit();
  }

  return {
    undo: {
      isEnabled: computed(() => document.undoLabel.value !== null || document.isDragging.value),
      run() {
        step(document.undo);
        messages.announce(`Undone: ${document.redoLabel.peek() ?? ""}`);
      },
    },
    redo: {
      isEnabled: computed(() => document.redoLabel.value !== null),
      run() {
        step(document.redo);
        messages.announce(`Redone: ${document.undoLabel.peek() ?? ""}`);
      },
    },
    "select-all": {
      isEnabled: computed(() => mainTrack(document.scene.value).agents.length > 0),
      run() {
        document.selection.value = { kind: "agents", agents: allAgents(document.scene.peek()) };
      },
    },
  };
}

/** Edits keep the parts they do not change; a scene that is opened shares none. */
function isAnother(before: Scene, after: Scene): boolean {
  return before.stage !== after.stage && mainTrack(before).agents !== mainTrack(after).agents;
}
