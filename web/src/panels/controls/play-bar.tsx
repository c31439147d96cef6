import { Pause, Play } from "lucide";
import { Icon } from "../../theme/icons";
import type { Quantity } from "./quantity";
import { Slider } from "./slider";

/** Plays something of its own, apart from the show, and walks through it. */
export function PlayBar(props: {
  /** What the button reads before and while it plays. */
  play: string;
  pause: string;
  /** Of the slider. */
  label: string;
  isPlaying: boolean;
  value: number;
  max: number;
  step: number;
  /** Where it is, as the slider says it. */
  format(value: number): string;
  /** Where it is, as it stands at the end. */
  clock: string;
  /** The keyboard begins here. */
  isFirst?: boolean;
  onToggle(): void;
  onSeek(value: number): void;
}) {
  const quantity: Quantity = {
    min: 0,
    max: props.max,
    step: props.step,
    scale: "linear",
    unit: "",
    format: props.format,
    parse: () => null,
  };
  return (
    <div class="play-bar">
      <button
        type="button"
        class="icon-button"
        aria-label={props.isPlaying ? props.pause : props.play}
        autofocus={props.isFirst ?? false}
        onClick={props.onToggle}
      >
        <Icon node={props.isPlaying ? Pause : Play} />
      </button>
      <Slider
        label={props.label}
        value={props.value}
        quantity={quantity}
        onPreview={props.onSeek}
        onCommit={() => {}}
        onCancel={() => {}}
      />
      <span class="number">{props.clock}</span>
    </div>
  );
}
