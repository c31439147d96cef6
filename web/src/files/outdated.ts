import { effect } from "@preact/signals";
import { mainTrack } from "../document/scene";
import type { DocumentStore } from "../document/store";
import { type Messages, OPENING } from "../panels/messages";

/** What was said about opening a scene goes when another takes its place, whichever way, from now on. */
export function withdrawOutdated({ scene }: Pick<DocumentStore, "scene">, messages: Messages): void {
  let known: ReadonlySet<unknown> | null = null;
  effect(() => {
    const formations = mainTrack(scene.value).keyframes.map(({ positions }) => positions);
    const last = known;
    known = new Set(formations);
    if (last && !formations.some((formation) => last.has(formation))) messages.withdraw(OPENING);
  });
}
