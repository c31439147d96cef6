import { changesCast } from "./absence";
import type { Join, Track } from "./scene";

/** Whether agents stop at a keyframe: at every one where transitions are separate, else at the ends, corners, holds, and where somebody comes or goes. */
export function isStop(track: Track, join: Join, keyframe: number): boolean {
  const at = track.keyframes[keyframe];
  const isEnd = keyframe <= 0 || keyframe >= track.keyframes.length - 1;
  return join === "separate" || isEnd || !at || at.corner || at.hold > 0 || changesCast(track, keyframe);
}
