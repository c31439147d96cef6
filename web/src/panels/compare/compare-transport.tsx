import { Pause, Play } from "lucide";
import { formatTime } from "../../document/units";
import type { Playback } from "../../playback/playback";
import { Icon } from "../../theme/icons";
import type { Quantity } from "../controls/quantity";
import { Slider } from "../controls/slider";

/** Plays both sides, and walks through them. */
export function CompareTransport({ playback }: { playback: Playback }) {
  const { from, to } = playback.range.value ?? { from: 0, to: playback.duration.value };
  const isPlaying = playback.isPlaying.value;
  const quantity: Quantity = {
    min: 0,
    max: to - from,
    step: 0.1,
    scale: "linear",
    unit: "",
    format: formatTime,
    parse: () => null,
  };
  return (
    <div class="compare-transport">
      <button
        type="button"
        class="icon-button compare-play"
        aria-label={isPlaying ? "Pause" : "Play"}
        autofocus
        onClick={() => playback.toggle()}
      >
        <Icon node={isPlaying ? Pause : Play} />
      </button>
      <Slider
        label="Time"
        value={playback.time.value - from}
        quantity={quantity}
        onPreview={(time) => playback.seek(from + time)}
        onCommit={() => {}}
        onCancel={() => {}}
      />
      <span class="number">{formatTime(playback.time.value - from)}</span>
    </div>
  );
}
