import { effect } from "@preact/signals";
import { mainTrack, type Scene } from "../document/scene";
import type { DocumentStore } from "../document/store";
import { type Messages, OPENING } from "../panels/messages";

/** What was said about opening a scene goes when another takes its place, whichever way, from now on. */
export function withdrawOutdated({ scene }: Pick<DocumentStore, "scene">, messages: Messages): void {
  let last = scene.peek();
  effect(() => {
    const [before, now] = [last, scene.value];
    last = now;
    // A drag changes the scene many times a second, and mostly nothing was said.
    if (!messages.shown.peek().some(({ about }) => about === OPENING)) return;
    if (now !== before && !haveFormationInCommon(before, now)) messages.withdraw(OPENING);
  });
}

function haveFormationInCommon(one: Scene, other: Scene): boolean {
  const known = new Set(mainTrack(one).keyframes.map(({ positions }) => positions));
  return mainTrack(other).keyframes.some(({ positions }) => known.has(positions));
}
