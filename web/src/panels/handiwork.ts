import { type ArrangeId, arrangeActions } from "./arrange-actions";
import { clipboardActions, createAgentClipboard } from "./clipboard-actions";
import type { AgentClipboard } from "./clipboard-events";
import type { ActionParts, Doings } from "./doing";
import { type EditId, editActions } from "./edit-actions";
import { type KeyframeId, keyframeActions } from "./keyframe-actions";

export type HandiworkId = EditId | ArrangeId | KeyframeId | "copy" | "paste";

/** What changes the scene by an action: on what is selected, on keyframes, by pasting. */
export interface Handiwork {
  readonly doings: Doings<HandiworkId>;
  readonly clipboard: AgentClipboard;
}

export function createHandiwork(parts: ActionParts): Handiwork {
  const clipboard = createAgentClipboard(parts);
  return {
    clipboard,
    doings: {
      ...editActions(parts),
      ...keyframeActions(parts),
      ...arrangeActions(parts),
      ...clipboardActions(parts, clipboard),
    },
  };
}
