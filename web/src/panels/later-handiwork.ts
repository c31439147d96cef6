import { computed, effect, type ReadonlySignal, signal } from "@preact/signals";
import { mainTrack } from "../document/scene";
import type { DocumentStore } from "../document/store";
import type { AgentClipboard } from "./clipboard-events";
import type { ActionParts, Doing, Doings } from "./doing";
import type { Handiwork, HandiworkId } from "./handiwork";
import { NOT_LOADED } from "./messages";

/** Handiwork that may still be on its way: what is asked of it meanwhile is done when it comes. */
export interface LaterHandiwork {
  doing(id: HandiworkId): Doing;
  readonly clipboard: AgentClipboard;
}

/** Fetched when something is selected for the first time, or an action of its is run. */
export function laterHandiwork(parts: ActionParts): LaterHandiwork {
  const ready = signal<Handiwork | null>(null);
  let loading: Promise<Handiwork> | null = null;

  function load(): Promise<Handiwork> {
    loading ??= import("./handiwork").then(
      (chunk) => {
        const handiwork = chunk.createHandiwork(parts);
        ready.value = handiwork;
        return handiwork;
      },
      (error: unknown) => {
        loading = null;
        parts.messages.say(NOT_LOADED);
        throw error;
      },
    );
    return loading;
  }

  effect(() => {
    if (parts.document.selection.value.kind !== "none") load().catch(() => {});
  });

  return handiworkThrough(ready, load, parts);
}

/** The doings as they are, or as they will be. */
export function handiworkThrough(
  ready: ReadonlySignal<Handiwork | null>,
  load: () => Promise<Handiwork>,
  { document }: ActionParts,
): LaterHandiwork {
  function run(doings: Doings<HandiworkId>, id: HandiworkId): void {
    const doing: Doing = doings[id];
    if (doing.isEnabled?.peek() ?? true) doing.run();
  }
  return {
    doing: (id) => ({
      isEnabled: computed(() => {
        const doing: Doing | undefined = ready.value?.doings[id];
        return doing ? (doing.isEnabled?.value ?? true) : isLikely(id, document);
      }),
      run() {
        const now = ready.peek();
        if (now) run(now.doings, id);
        else
          load().then(
            (handiwork) => run(handiwork.doings, id),
            () => {},
          );
      },
    }),
    clipboard: {
      copied: () => ready.peek()?.clipboard.copied() ?? "",
      paste: (text) => load().then((handiwork) => handiwork.clipboard.paste(text)),
    },
  };
}

/** Whether an action that is not here yet will be possible; it decides for itself when it comes. */
function isLikely(id: HandiworkId, { scene, selection }: DocumentStore): boolean {
  switch (id) {
    case "paste":
    case "add-keyframe":
    case "duplicate-keyframe":
      return true;
    case "delete-keyframe":
      return mainTrack(scene.value).keyframes.length > 1;
    default:
      return selection.value.kind !== "none";
  }
}
