import { computed } from "@preact/signals";
import { addKeyframe, deleteKeyframe, duplicateKeyframe } from "../document/commands/keyframes";
import { setAllTransitions } from "../document/commands/transitions";
import { keyframeLabel } from "../document/queries";
import { mainTrack } from "../document/scene";
import type { Command } from "../document/store";
import { momentAt, slotAfter } from "../document/timing";
import { type ActionParts, type Doings, here, performOrSay } from "./doing";

type ShowId =
  | "play"
  | "previous-keyframe"
  | "next-keyframe"
  | "go-to-start"
  | "go-to-end"
  | "loop"
  | "add-keyframe"
  | "duplicate-keyframe"
  | "delete-keyframe"
  | "use-everywhere";

const NO_ROOM = "There is no room for a keyframe here: the next one is too near, or the show has all it can hold.";

/** The course of the show: playing it, its keyframes and transitions. */
export function showActions(parts: ActionParts): Doings<ShowId> {
  const { document, playback, messages } = parts;
  const keyframeCount = computed(() => mainTrack(document.scene.value).keyframes.length);

  function goTo(index: number): void {
    const keyframe = mainTrack(document.scene.peek()).keyframes[index];
    if (!keyframe) return;
    playback.pause();
    document.selection.value = { kind: "keyframe", index };
    playback.seek(keyframe.time);
    messages.announce(keyframeLabel(document.scene.peek(), index));
  }

  /** Makes a keyframe after the one at `time`, and goes there. */
  function make(time: number, command: Command): void {
    const slot = slotAfter(document.scene.peek(), time);
    if (performOrSay(parts, command, NO_ROOM) && slot) goTo(slot.index);
  }

  return {
    play: {
      isEnabled: computed(() => playback.duration.value > 0),
      run: () => playback.toggle(),
    },
    "previous-keyframe": {
      run() {
        const moment = momentAt(document.scene.peek(), playback.time.peek());
        goTo(moment.kind === "moving" ? moment.segment : Math.max(0, moment.keyframe - 1));
      },
    },
    "next-keyframe": {
      run() {
        const moment = momentAt(document.scene.peek(), playback.time.peek());
        const before = moment.kind === "moving" ? moment.segment : moment.keyframe;
        goTo(Math.min(keyframeCount.peek() - 1, before + 1));
      },
    },
    "go-to-start": { run: () => playback.seek(0) },
    "go-to-end": { run: () => playback.seek(playback.duration.peek()) },
    loop: {
      run() {
        playback.isLooping.value = !playback.isLooping.peek();
        messages.announce(playback.isLooping.peek() ? "Loop on" : "Loop off");
      },
    },
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
