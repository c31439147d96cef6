import { effect } from "@preact/signals";
import { mainTrack } from "../document/scene";
import type { DocumentStore } from "../document/store";
import { momentAt } from "../document/timing";
import type { Playback } from "../playback/playback";

/**
 * Keeps the edited keyframe and the playhead together: where the playhead stands is edited, and the playhead goes to
 * the keyframe that is picked. While agents move, the edited keyframe stays the one before. Answers how to stop.
 */
export function followPlayhead(document: DocumentStore, playback: Playback): () => void {
  let isStanding = true;
  let lastActive = document.activeKeyframe.peek();

  const stopFollowing = effect(() => {
    const moment = momentAt(document.scene.peek(), playback.time.value);
    isStanding = moment.kind === "standing";
    if (moment.kind === "standing") document.activeKeyframe.value = moment.keyframe;
  });

  // A keyframe that is picked, or that moves in time with the playhead on it, takes the playhead along.
  const stopLeading = effect(() => {
    const active = document.activeKeyframe.value;
    const scene = document.scene.value;
    const keyframe = mainTrack(scene).keyframes[active];
    const moment = momentAt(scene, playback.time.peek());
    const isThere = moment.kind === "standing" && moment.keyframe === active;
    const wasPicked = active !== lastActive;
    lastActive = active;
    if (keyframe && !isThere && (wasPicked || isStanding) && !playback.isPlaying.peek()) playback.seek(keyframe.time);
  });

  return () => {
    stopFollowing();
    stopLeading();
  };
}
