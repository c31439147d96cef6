import type { Formation } from "../document/formation";
import type { Track } from "../document/scene";
import type { Show } from "../playback/show";

/** The formations that agents come from and go to at some time. */
export interface Onion {
  readonly from: Formation | null;
  readonly to: Formation | null;
  /** The transition whose spacing both are drawn with. */
  readonly segment: number;
}

/** Under way: the transition's two keyframes. Standing: the keyframes before and after. */
export function onionAt(track: Track, show: Show, time: number): Onion {
  const keyframe = show.keyframeBefore(time);
  const segment = show.segmentAt(time);
  const before = segment === null ? keyframe - 1 : keyframe;
  return {
    from: track.keyframes[before]?.positions ?? null,
    to: track.keyframes[keyframe + 1]?.positions ?? null,
    segment: segment ?? Math.max(keyframe - 1, 0),
  };
}
