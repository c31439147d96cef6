import { computed } from "@preact/signals";
import { addKeyframe, deleteKeyframe, duplicateKeyframe } from "../document/commands/keyframes";
import { setAllTransitions } from "../document/commands/transitions";
import { keyframeLabel } from "../document/queries";
import { mainTrack } from "../document/scene";
import type { Command } from "../document/store";
import { momentAt, slotAfter } from "../document/timing";
import { type ActionParts, type Doings, here, performOrSay } from "./doing";
import { goToKeyframe } from "./show-actions";

export type KeyframeId = "add-keyframe" | "duplicate-keyframe" | "delete-keyframe" | "use-everywhere";

const NO_ROOM = "There is no room for a keyframe here: the next one is too near, or the show has all it can hold.";

/** What is done to keyframes and transitions. */
export function keyframeActions(parts: ActionParts): Doings<KeyframeId> {
  const { document, playback, messages } = parts;
  const keyframeCount = computed(() => mainTrack(document.scene.value).keyframes.length);
  const goTo = (index: number) => goToKeyframe(parts, index);

  /** Makes a keyframe after the one at `time`, and goes there. */
  function make(time: number, command: Command): void {
    const slot = slotAfter(document.scene.peek(), time);
    if (performOrSay(parts, command, NO_ROOM) && slot) goTo(slot.index);
  }

  return {
    "add-keyframe": {
      run() {
        playback.pause();
        const time = playback.time.peek();
        const moment = momentAt(document.scene.peek(), time);
        const standing = moment.kind === "standing" ? moment.keyframe : -1;
        // A formation that stands is taken as it is stored: what the stage shows is rounded.
        const stored = mainTrack(document.scene.peek()).keyframes[standing]?.positions;
        make(time, addKeyframe(time, stored ?? parts.positionsAt(time)));
      },
    },
    "duplicate-keyframe": {
      run() {
        const { scene, keyframe } = here(document);
        const original = mainTrack(scene).keyframes[keyframe];
        if (original) make(original.time + original.hold, duplicateKeyframe(keyframe));
      },
    },
    "delete-keyframe": {
      isEnabled: computed(() => keyframeCount.value > 1),
      run() {
        const { scene, keyframe } = here(document);
        const name = keyframeLabel(scene, keyframe);
        document.perform(deleteKeyframe(keyframe));
        goTo(document.activeKeyframe.peek());
        messages.announce(`${name} deleted`);
      },
    },
    "use-everywhere": {
      isEnabled: computed(() => document.selection.value.kind === "transition" && keyframeCount.value > 2),
      run() {
        const { scene, selection } = here(document);
        const segment = selection.kind === "transition" ? mainTrack(scene).segments[selection.index] : undefined;
        if (!segment) return;
        const { method, order, alignment, sharing, keepSize, timing } = segment;
        document.perform(setAllTransitions({ method, order, alignment, sharing, keepSize, timing }));
      },
    },
  };
}
