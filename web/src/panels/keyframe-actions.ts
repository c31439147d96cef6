import { computed } from "@preact/signals";
import { addKeyframe, deleteKeyframe, duplicateKeyframe } from "../document/commands/keyframes";
import { copyOfRun, repeatRun, reverseRun, whyNotRepeated, whyNotReversed } from "../document/commands/runs";
import { setAllTransitions } from "../document/commands/transitions";
import { keyframeLabel } from "../document/queries";
import { selectedRun } from "../document/run";
import { mainTrack } from "../document/scene";
import { slotAfter } from "../document/slot";
import type { Command } from "../document/store";
import { liesBetween } from "../document/stretches";
import { momentAt } from "../document/timing";
import { choiceOf } from "../engine/choice";
import { type ActionParts, type Doings, here, performOrSay } from "./doing";
import { goToKeyframe } from "./show-actions";
import { whenPlanned } from "./when-planned";

export type KeyframeId =
  | "add-keyframe"
  | "duplicate-keyframe"
  | "delete-keyframe"
  | "reverse-run"
  | "repeat-run"
  | "use-everywhere";

/** What is said while a keyframe waits for the motion. */
const CAPTURING = "capturing";

const NO_ROOM = "There is no room for a keyframe here: the next one is too near, or the show has all it can hold.";

/** What is done to keyframes and transitions. */
export function keyframeActions(parts: ActionParts): Doings<KeyframeId> {
  const { document, playback, messages, planner } = parts;
  const keyframeCount = computed(() => mainTrack(document.scene.value).keyframes.length);
  const hasRun = computed(() => selectedRun(document.selection.value) !== null);
  const goTo = (index: number) => goToKeyframe(parts, index);

  /** Makes a keyframe after the one at `time`, and goes there. */
  function make(time: number, command: Command): void {
    const slot = slotAfter(document.scene.peek(), time);
    if (performOrSay(parts, command, NO_ROOM) && slot) goTo(slot.index);
  }

  /** Makes a keyframe of the formation that moves by at `time`: while the motion is planned, what is seen is none of it. */
  function capture(time: number, segment: number): void {
    const say = { tone: "good", title: "The keyframe comes with the motion.", text: "It is being planned." } as const;
    const take = async () => {
      messages.withdraw(CAPTURING);
      const scene = document.scene.peek();
      const state = planner.segments.peek()[segment];
      // The keyframe goes to a whole millisecond: the formation is the one of that instant.
      const at = slotAfter(scene, time)?.time ?? time;
      const exact = state?.kind === "ready" ? await planner.placesAt(scene, segment, at).catch(() => null) : null;
      if (document.scene.peek() === scene)
        make(time, addKeyframe(time, exact ?? parts.positionsAt(at), choiceOf(state)));
    };
    const isMade = whenPlanned(
      parts,
      segment,
      () => void take(),
      () => messages.withdraw(CAPTURING),
    );
    if (!isMade) messages.say({ ...say, about: CAPTURING });
  }

  return {
    "add-keyframe": {
      run() {
        playback.pause();
        const time = playback.time.peek();
        const track = mainTrack(document.scene.peek());
        const moment = momentAt(document.scene.peek(), time);
        const isStanding = moment.kind === "standing" && !liesBetween(track, moment.keyframe);
        if (isStanding) {
          // A formation that stands is taken as it is stored: what the stage shows is rounded.
          const stored = track.keyframes[moment.keyframe]?.positions;
          if (stored) make(time, addKeyframe(time, stored));
          return;
        }
        capture(time, moment.kind === "moving" ? moment.segment : moment.keyframe);
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
    "reverse-run": {
      isEnabled: hasRun,
      run() {
        const run = selectedRun(document.selection.peek());
        if (!run) return;
        const { scene } = here(document);
        if (!performOrSay(parts, reverseRun(run), whyNotReversed(scene, run) ?? NO_ROOM)) return;
        messages.announce(`Keyframes ${run.first + 1} to ${run.last + 1} reversed`);
      },
    },
    "repeat-run": {
      isEnabled: hasRun,
      run() {
        const run = selectedRun(document.selection.peek());
        if (!run) return;
        const { scene } = here(document);
        const copy = copyOfRun(scene, run);
        if (!performOrSay(parts, repeatRun(run), whyNotRepeated(scene, run) ?? NO_ROOM)) return;
        document.selection.value = { kind: "keyframe", index: copy.last, anchor: copy.first };
        messages.announce(`Keyframes ${run.first + 1} to ${run.last + 1} repeated`);
      },
    },
    "use-everywhere": {
      isEnabled: computed(() => document.selection.value.kind === "transition" && keyframeCount.value > 2),
      run() {
        const { scene, selection } = here(document);
        const segment = selection.kind === "transition" ? mainTrack(scene).segments[selection.index] : undefined;
        if (!segment) return;
        const { kind: _, chosen: __, assignment: ___, ...options } = segment;
        document.perform(setAllTransitions(options));
        messages.announce("Every transition has its method and options now.");
      },
    },
  };
}
