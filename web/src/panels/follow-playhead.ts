import { effect } from "@preact/signals";
import { mainTrack } from "../document/scene";
import type { DocumentStore } from "../document/store";
import { standingAt } from "../document/timing";
import type { Playback } from "../playback/playback";

/**
 * Keeps the edited keyframe and the playhead together: where the playhead stands is edited, and the playhead goes to
 * the keyframe that is picked. While agents move, the edited keyframe stays the one before. Answers how to stop.
 */
export function followPlayhead(document: DocumentStore, playback: Playback): () => void {
  let isStanding = true;
  let lastActive = document.activeKeyframe.peek();

  function take(time: number): void {
    const keyframe = standingAt(document.scene.value, time);
    isStanding = keyframe !== null;
    if (keyframe !== null) document.activeKeyframe.value = keyframe;
  }
  take(playback.time.peek());
  const stopFollowing = playback.follow(take);

  // A keyframe that is picked, or that moves in time with the playhead on it, takes the playhead along.
  const stopLeading = effect(() => {
    const active = document.activeKeyframe.value;
    const scene = document.scene.value;
    const keyframe = mainTrack(scene).keyframes[active];
    const isThere = standingAt(scene, playback.time.peek()) === active;
    const wasPicked = active !== lastActive;
    lastActive = active;
    if (keyframe && !isThere && (wasPicked || isStanding) && !playback.isPlaying.peek()) playback.seek(keyframe.time);
  });

  return () => {
    stopFollowing();
    stopLeading();
  };
}
