import { goneIn } from "../document/absence";
import type { Keyframe, Track } from "../document/scene";
import type { Show } from "../playback/show";

/** The formations that agents come from and go to; one is kept and refilled. */
export class Onion {
  from: Keyframe | null = null;
  to: Keyframe | null = null;
  /** Who is not on the way from the one, and to the other. */
  goneFrom: readonly number[] = [];
  goneTo: readonly number[] = [];
  /** The transition whose spacing both are drawn with. */
  segment = 0;
  /** The keyframe stood in or left. */
  private at: Keyframe | null = null;

  /** Under way: the transition's two keyframes. Standing: the keyframes before and after. Answers whether they changed. */
  take(track: Track, show: Show, time: number): boolean {
    const keyframe = show.keyframeBefore(time);
    const segment = show.segmentAt(time);
    const before = segment === null ? keyframe - 1 : keyframe;
    const from = track.keyframes[before] ?? null;
    const to = track.keyframes[keyframe + 1] ?? null;
    const at = track.keyframes[keyframe] ?? null;
    const isOther = from !== this.from || to !== this.to || at !== this.at;
    if (isOther) {
      this.goneFrom = goneIn(track, before);
      this.goneTo = goneIn(track, keyframe);
    }
    this.from = from;
    this.to = to;
    this.at = at;
    this.segment = segment ?? Math.max(keyframe - 1, 0);
    return isOther;
  }
}
