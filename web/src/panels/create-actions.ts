import { computed } from "@preact/signals";
import { mainTrack } from "../document/scene";
import type { Action, Actions } from "./actions";
import type { Aside } from "./aside";
import type { ActionParts, Doing, Doings } from "./doing";
import type { HandiworkId } from "./handiwork";
import { historyActions } from "./history-actions";
import type { LaterHandiwork } from "./later-handiwork";
import { type ActionId, keysOf, SHORTCUTS } from "./shortcuts";
import { showActions } from "./show-actions";
import { viewActions } from "./view-actions";

/** Every action of the page: the words and keys of the table with what they do. */
export function createActions(parts: ActionParts, handiwork: LaterHandiwork): Actions {
  const { files, aside, document } = parts;
  const look = (kind: Aside["kind"]): Doing => ({
    run() {
      aside.value = { kind };
    },
  });
  const doings: Doings<ActionId> = {
    ...viewActions(parts),
    ...showActions(parts),
    ...historyActions(parts),
    ...handiworkDoings(handiwork),
    modes: look("modes"),
    recording: look("recording"),
    compare: {
      isEnabled: computed(() => mainTrack(document.scene.value).segments.length > 0),
      run: files.compare,
    },
    "shape-from-picture": { run: files.picture },
    "shape-from-text": { run: files.text },
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

const HANDIWORK = [
  "duplicate",
  "delete",
  "nudge-left",
  "nudge-right",
  "nudge-up",
  "nudge-down",
  "push-left",
  "push-right",
  "push-up",
  "push-down",
  "nudge-higher",
  "nudge-lower",
  "push-higher",
  "push-lower",
  "align-left",
  "align-center",
  "align-right",
  "align-top",
  "align-middle",
  "align-bottom",
  "distribute-horizontally",
  "distribute-vertically",
  "flip-horizontal",
  "flip-vertical",
  "rotate-left",
  "rotate-right",
  "make-group",
  "dissolve-group",
  "tie-selected",
  "tie-group",
  "copy",
  "paste",
  "add-keyframe",
  "duplicate-keyframe",
  "delete-keyframe",
  "reverse-run",
  "repeat-run",
  "use-everywhere",
] as const satisfies readonly HandiworkId[];

function handiworkDoings(handiwork: LaterHandiwork): Doings<HandiworkId> {
  const doings = HANDIWORK.map((id) => [id, handiwork.doing(id)] as const);
  // The list above names each of them: a missing one fails the table of actions in its test.
  return Object.fromEntries(doings) as Doings<HandiworkId>;
}
