import type { Formation } from "../document/formation";
import type { Track } from "../document/scene";
import type { Show } from "../playback/show";

/** The formations that agents come from and go to; one is kept and refilled. */
export class Onion {
  from: Formation | null = null;
  to: Formation | null = null;
  /** The transition whose spacing both are drawn with. */
  segment = 0;

  /** Under way: the transition's two keyframes. Standing: the keyframes before and after. Answers whether they changed. */
  take(track: Track, show: Show, time: number): boolean {
    const keyframe = show.keyframeBefore(time);
    const segment = show.segmentAt(time);
    const from = track.keyframes[segment === null ? keyframe - 1 : keyframe]?.positions ?? null;
    const to = track.keyframes[keyframe + 1]?.positions ?? null;
    const isOther = from !== this.from || to !== this.to;
    this.from = from;
    this.to = to;
    this.segment = segment ?? Math.max(keyframe - 1, 0);
    return isOther;
  }
}
