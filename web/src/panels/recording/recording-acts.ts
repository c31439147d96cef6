import { openScene } from "../../document/open-scene";
import type { Studio } from "../studio";
import { sceneOf, shiftOf } from "./picks";
import { isOriginalShown, isWalked, type OpenRecording, opened, recorded } from "./state";

/** Shows all the ground that the recording covers. */
export function lookAt({ view, playback }: Studio, { recording }: OpenRecording): void {
  playback.pause();
  view.projection.value = "plan";
  const bounds = recording.bounds();
  if (!bounds) return;
  const [dx, dy] = shiftOf(recording);
  const { minX, maxX, minY, maxY } = bounds;
  view.show({ minX: minX + dx, maxX: maxX + dx, minY: minY + dy, maxY: maxY + dy });
}

/** The scene takes the place of the one before, which is one undo away. */
export function makeScene({ document, playback, view, messages }: Studio, open: OpenRecording): void {
  const { recording, picks, name } = open;
  recorded.pause();
  openScene(document, sceneOf(recording, picks, name.replace(/\.[a-z]+$/i, "")), "Make scene from recording");
  opened.value = { ...open, made: picks };
  isWalked.value = false;
  isOriginalShown.value = true;
  playback.pause();
  playback.seek(0);
  view.fit();
  messages.announce("The scene is made. Play it to see it beside the recording.");
}
