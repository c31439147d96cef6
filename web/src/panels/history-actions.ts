import { computed } from "@preact/signals";
import { allAgents } from "../document/queries";
import { mainTrack } from "../document/scene";
import type { ActionParts, Doings } from "./doing";

/** What a person can do before anything is selected. */
export function historyActions({ document, messages }: ActionParts): Doings<"undo" | "redo" | "select-all"> {
  return {
    undo: {
      isEnabled: computed(() => document.undoLabel.value !== null || document.isDragging.value),
      run() {
        document.undo();
        messages.announce(`Undone: ${document.redoLabel.peek() ?? ""}`);
      },
    },
    redo: {
      isEnabled: computed(() => document.redoLabel.value !== null),
      run() {
        document.redo();
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
