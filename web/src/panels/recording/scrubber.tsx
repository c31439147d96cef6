import { Pause, Play } from "lucide";
import { formatTime } from "../../document/units";
import type { Recording } from "../../engine/recording";
import { Icon } from "../../theme/icons";
import type { Quantity } from "../controls/quantity";
import { Slider } from "../controls/slider";
import { isWalked, recorded } from "./state";

/** Plays the recording and walks through it, apart from the show's own time. */
export function Scrubber({ recording }: { recording: Recording }) {
  const isPlaying = recorded.isPlaying.value;
  const quantity: Quantity = {
    min: 0,
    max: recording.frameCount - 1,
    step: 1,
    scale: "linear",
    unit: "",
    format: (frame) => formatTime(recording.timeOf(frame)),
    parse: () => null,
  };
  return (
    <div class="recording-scrubber">
      <button
        type="button"
        class="icon-button"
        aria-label={isPlaying ? "Pause recording" : "Play recording"}
        onClick={() => {
          isWalked.value = true;
          recorded.toggle();
        }}
      >
        <Icon node={isPlaying ? Pause : Play} />
      </button>
      <Slider
        label="Frame"
        value={recording.frameAt(recorded.time.value)}
        quantity={quantity}
        onPreview={(frame) => {
          isWalked.value = true;
          recorded.seek(recording.timeOf(Math.round(frame)));
        }}
        onCommit={() => {}}
        onCancel={() => {}}
      />
      <span class="number">{formatTime(recorded.time.value)}</span>
    </div>
  );
}
