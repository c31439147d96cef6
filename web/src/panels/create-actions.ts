import type { Action, Actions } from "./actions";
import { arrangeActions } from "./arrange-actions";
import { type AgentClipboard, clipboardActions } from "./clipboard-actions";
import type { ActionParts, Doing, Doings } from "./doing";
import { editActions } from "./edit-actions";
import { type ActionId, keysOf, SHORTCUTS } from "./shortcuts";
import { showActions } from "./show-actions";
import { viewActions } from "./view-actions";

/** Every action of the page: the words and keys of the table with what they do. */
export function createActions(parts: ActionParts, agents: AgentClipboard): Actions {
  const { files } = parts;
  const doings: Doings<ActionId> = {
    ...viewActions(parts),
    ...showActions(parts),
    ...editActions(parts),
    ...arrangeActions(parts),
    ...clipboardActions(parts, agents),
    new: { run: files.new },
    open: { run: files.open },
    save: { run: files.save },
    export: { run: files.export },
    share: { run: files.share },
    examples: { run: files.examples },
    palette: { run: files.palette },
    help: { run: files.help },
  };
  const all = (Object.keys(SHORTCUTS) as ActionId[]).map((id) => actionOf(id, doings[id]));
  const byId = new Map(all.map((action) => [action.id, action]));
  return {
    all,
    get(id) {
      const action = byId.get(id);
      if (!action) throw new Error(`there is no action ${id}`);
      return action;
    },
  };
}

function actionOf(id: ActionId, doing: Doing): Action {
  const { label, section } = SHORTCUTS[id];
  return { id, label, section, keys: keysOf(id), ...doing };
}
