import { effect } from "@preact/signals";
import { mainTrack } from "../document/scene";
import type { DocumentStore } from "../document/store";
import { type Messages, OPENING } from "../panels/messages";

/** What was said about opening a scene goes when another takes its place, whichever way. */
export function withdrawOutdated({ scene }: Pick<DocumentStore, "scene">, messages: Messages): void {
  let known = new Set<unknown>();
  effect(() => {
    const formations = mainTrack(scene.value).keyframes.map(({ positions }) => positions);
    if (!formations.some((formation) => known.has(formation))) messages.withdraw(OPENING);
    known = new Set(formations);
  });
}
