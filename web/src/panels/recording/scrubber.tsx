import { formatTime } from "../../document/units";
import type { Recording } from "../../engine/recording";
import { PlayBar } from "../controls/play-bar";
import { isWalked, recorded } from "./state";

/** Plays the recording and walks through it, apart from the show's own time. */
export function Scrubber({ recording }: { recording: Recording }) {
  return (
    <div class="recording-scrubber">
      <PlayBar
        play="Play recording"
        pause="Pause recording"
        label="Frame"
        isPlaying={recorded.isPlaying.value}
        value={recording.frameAt(recorded.time.value)}
        max={recording.frameCount - 1}
        step={1}
        format={(frame) => formatTime(recording.timeOf(frame))}
        clock={formatTime(recorded.time.value)}
        onToggle={() => {
          isWalked.value = true;
          recorded.toggle();
        }}
        onSeek={(frame) => {
          isWalked.value = true;
          recorded.seek(recording.timeOf(Math.round(frame)));
        }}
      />
    </div>
  );
}
