import { useComputed, useSignalEffect } from "@preact/signals";
import { Copy, Pause, Play, Plus, Repeat, SkipBack, SkipForward, Trash2 } from "lucide";
import { useRef } from "preact/hooks";
import { mainTrack } from "../../document/scene";
import { formatTime } from "../../document/units";
import { Icon } from "../../theme/icons";
import { useStudio } from "../studio";
import { shortTime } from "./clock";
import { Legend } from "./legend";

const SPEEDS = [0.25, 0.5, 0.75, 1, 1.5, 2];

/** Play, where the show is, how it repeats; at the right what one does to keyframes. */
export function Transport() {
  const { playback } = useStudio();
  const isEmpty = playback.duration.value <= 0;
  const isPlaying = playback.isPlaying.value;
  return (
    <div class="transport">
      <button
        type="button"
        class="icon-button"
        aria-label="To start"
        disabled={isEmpty}
        onClick={() => playback.seek(0)}
      >
        <Icon node={SkipBack} />
      </button>
      <button
        type="button"
        class="play-button"
        aria-label={isPlaying ? "Pause" : "Play"}
        aria-keyshortcuts="Space"
        disabled={isEmpty}
        onClick={() => playback.toggle()}
      >
        <Icon node={isPlaying ? Pause : Play} size={14} />
      </button>
      <button
        type="button"
        class="icon-button"
        aria-label="To end"
        disabled={isEmpty}
        onClick={() => playback.seek(playback.duration.value)}
      >
        <Icon node={SkipForward} />
      </button>
      <Clock />
      <button
        type="button"
        class="icon-button loop-button"
        aria-label="Loop"
        aria-pressed={playback.isLooping.value}
        onClick={() => {
          playback.isLooping.value = !playback.isLooping.value;
        }}
      >
        <Icon node={Repeat} />
      </button>
      <select
        class="speed number"
        aria-label="Speed"
        value={String(playback.speed.value)}
        onChange={(event) => {
          playback.speed.value = Number(event.currentTarget.value);
        }}
      >
        {SPEEDS.map((speed) => (
          <option key={speed} value={String(speed)}>
            {speed}×
          </option>
        ))}
      </select>
      <span class="transport-gap" />
      <Legend />
      <KeyframeButtons />
    </div>
  );
}

/** Written straight into the text while the show runs: a frame renders nothing. */
function Clock() {
  const { playback } = useStudio();
  const now = useRef<HTMLSpanElement>(null);
  const text = useComputed(() => formatTime(playback.time.value));
  useSignalEffect(() => {
    if (now.current) now.current.textContent = text.value;
  });
  return (
    <span class="clock number">
      <span ref={now} class="clock-now" /> <span class="unit">/ {shortTime(playback.duration.value)}</span>
    </span>
  );
}

function KeyframeButtons() {
  const { actions, document } = useStudio();
  const isOnly = mainTrack(document.scene.value).keyframes.length < 2;
  return (
    <div class="keyframe-buttons">
      <button
        type="button"
        class="icon-button"
        aria-label="Duplicate keyframe"
        onClick={() => actions.get("duplicate-keyframe").run()}
      >
        <Icon node={Copy} />
      </button>
      <button
        type="button"
        class="icon-button"
        aria-label="Delete keyframe"
        disabled={isOnly}
        onClick={() => actions.get("delete-keyframe").run()}
      >
        <Icon node={Trash2} />
      </button>
      <button
        type="button"
        class="button"
        aria-label="Add keyframe"
        aria-keyshortcuts="K"
        onClick={() => actions.get("add-keyframe").run()}
      >
        <Icon node={Plus} size={14} />
        Keyframe
      </button>
    </div>
  );
}
