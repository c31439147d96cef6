import { computed } from "@preact/signals";
import { keyframeLabel } from "../document/queries";
import { mainTrack } from "../document/scene";
import { momentAt } from "../document/timing";
import type { ActionParts, Doings } from "./doing";

type ShowId = "play" | "previous-keyframe" | "next-keyframe" | "go-to-start" | "go-to-end" | "loop" | "counts";

/** Stands at a keyframe and selects it. */
export function goToKeyframe({ document, playback, messages }: ActionParts, index: number): void {
  const keyframe = mainTrack(document.scene.peek()).keyframes[index];
  if (!keyframe) return;
  playback.pause();
  document.selection.value = { kind: "keyframe", index };
  playback.seek(keyframe.time);
  messages.announce(keyframeLabel(document.scene.peek(), index));
}

/** The course of the show: playing it and walking through it. */
export function showActions(parts: ActionParts): Doings<ShowId> {
  const { document, playback, view, messages } = parts;
  const keyframeCount = computed(() => mainTrack(document.scene.value).keyframes.length);

  const goTo = (index: number) => goToKeyframe(parts, index);

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
    counts: {
      run() {
        view.ruler.value = view.ruler.peek() === "counts" ? "seconds" : "counts";
        messages.announce(`The timeline reads ${view.ruler.peek()}`);
      },
    },
  };
}
