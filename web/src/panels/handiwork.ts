import { type ArrangeId, arrangeActions } from "./arrange-actions";
import { clipboardActions, createAgentClipboard } from "./clipboard-actions";
import type { AgentClipboard } from "./clipboard-events";
import type { ActionParts, Doings } from "./doing";
import { type EditId, editActions } from "./edit-actions";

export type HandiworkId = EditId | ArrangeId | "copy" | "paste";

/** What is done to agents once some are selected, or pasted. */
export interface Handiwork {
  readonly doings: Doings<HandiworkId>;
  readonly clipboard: AgentClipboard;
}

export function createHandiwork(parts: ActionParts): Handiwork {
  const clipboard = createAgentClipboard(parts);
  return {
    clipboard,
    doings: { ...editActions(parts), ...arrangeActions(parts), ...clipboardActions(parts, clipboard) },
  };
}
