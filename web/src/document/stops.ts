import { changesCast } from "./absence";
import type { Join, Track } from "./scene";
import { liesBetween } from "./stretches";

/**
 * Whether agents stop at a keyframe: at every one that ends a transition where these are separate, else at the ends of the
 * show, corners, holds, and where somebody comes or goes.
 */
export function isStop(track: Track, join: Join, keyframe: number): boolean {
  if (liesBetween(track, keyframe)) return false;
  const at = track.keyframes[keyframe];
  const isEnd = keyframe <= 0 || keyframe >= track.keyframes.length - 1;
  return join === "separate" || isEnd || !at || at.corner || at.hold > 0 || changesCast(track, keyframe);
}
