import { type ReadonlySignal, useComputed } from "@preact/signals";
import { keyframeLabel } from "../../document/queries";
import { mainTrack } from "../../document/scene";
import { formatTime } from "../../document/units";
import { useStudio } from "../studio";

/** Which instant the places are of, and whether they can be typed. */
export function TableFoot({ keyframe }: { keyframe: ReadonlySignal<number | null> }) {
  const { document, playback } = useStudio();
  const text = useComputed(() => {
    if (mainTrack(document.scene.value).agents.length === 0) return "Nobody yet. Draw a formation on the stage.";
    if (keyframe.value !== null)
      return `At ${keyframeLabel(document.scene.value, keyframe.value)}. Enter edits a cell.`;
    if (playback.isPlaying.value) return "Playing. Stop at a keyframe to edit places.";
    return `At ${formatTime(playback.time.value)}. Stop at a keyframe to edit places.`;
  });
  return <p class="table-foot number">{text}</p>;
}
