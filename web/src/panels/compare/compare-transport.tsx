import { formatTime } from "../../document/units";
import type { Playback } from "../../playback/playback";
import { PlayBar } from "../controls/play-bar";

/** Plays all ways in step, and walks through them. */
export function CompareTransport({ playback }: { playback: Playback }) {
  const { from, to } = playback.range.value ?? { from: 0, to: playback.duration.value };
  const time = playback.time.value - from;
  return (
    <div class="compare-transport">
      <PlayBar
        play="Play"
        pause="Pause"
        label="Time"
        isPlaying={playback.isPlaying.value}
        value={time}
        max={to - from}
        step={0.1}
        format={formatTime}
        clock={formatTime(time)}
        isFirst
        onToggle={() => playback.toggle()}
        onSeek={(seconds) => playback.seek(from + seconds)}
      />
    </div>
  );
}
