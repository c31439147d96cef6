import type { IconNode } from "lucide";
import { Copy, Ellipsis, Pause, Play, Plus, SkipBack, SkipForward, Trash2 } from "lucide";
import { Icon } from "../../theme/icons";
import { PopoverButton } from "../controls/popover";
import { lazily } from "../lazily";
import { useStudio } from "../studio";
import { keyName, keyShortcuts, useAction } from "../use-action";
import { Clock } from "./clock-face";
import { PlayWays } from "./play-ways";

const Legend = lazily(() => import("./legend").then((part) => part.Legend));
const TransportItems = lazily(() => import("./transport-items").then((part) => part.TransportItems));

/** Play, where the show is, how it repeats; at the right what one does to keyframes. */
export function Transport() {
  const { playback } = useStudio();
  const isEmpty = playback.duration.value <= 0;
  return (
    <div class="transport">
      <ActionButton id="go-to-start" name="To start" node={SkipBack} isOff={isEmpty} />
      <PlayButton />
      <ActionButton id="go-to-end" name="To end" node={SkipForward} isOff={isEmpty} />
      <Clock />
      <span class="transport-wide">
        <PlayWays />
      </span>
      <span class="transport-gap" />
      <Legend />
      <span class="transport-wide keyframe-buttons">
        <ActionButton id="duplicate-keyframe" name="Duplicate keyframe" node={Copy} />
        <ActionButton id="delete-keyframe" name="Delete keyframe" node={Trash2} />
      </span>
      <More />
      <AddButton />
    </div>
  );
}

function PlayButton() {
  const { playback } = useStudio();
  const { action, isEnabled } = useAction("play");
  const isPlaying = playback.isPlaying.value;
  return (
    <button
      type="button"
      class="play-button"
      aria-label={isPlaying ? "Pause" : "Play"}
      aria-keyshortcuts={keyShortcuts(action.keys)}
      disabled={!isEnabled}
      data-tip={isPlaying ? "Pause" : "Play"}
      data-tip-side="top"
      data-keys={action.keys[0] && keyName(action.keys[0])}
      onClick={() => action.run()}
    >
      <Icon node={isPlaying ? Pause : Play} size={14} />
    </button>
  );
}

function ActionButton(props: { id: string; name: string; node: IconNode; isOff?: boolean }) {
  const { action, isEnabled } = useAction(props.id);
  return (
    <button
      type="button"
      class="icon-button"
      aria-label={props.name}
      aria-keyshortcuts={keyShortcuts(action.keys)}
      disabled={!isEnabled || props.isOff}
      data-tip={props.name}
      data-tip-side="top"
      data-keys={action.keys[0] && keyName(action.keys[0])}
      onClick={() => action.run()}
    >
      <Icon node={props.node} />
    </button>
  );
}

function AddButton() {
  const { action, isEnabled } = useAction("add-keyframe");
  return (
    <button
      type="button"
      class="button add-keyframe"
      aria-label="Add keyframe"
      aria-keyshortcuts={keyShortcuts(action.keys)}
      disabled={!isEnabled}
      data-tip="The formation seen now, as a keyframe"
      data-tip-side="top"
      data-keys={action.keys[0] && keyName(action.keys[0])}
      onClick={() => action.run()}
    >
      <Icon node={Plus} size={14} />
      Keyframe
    </button>
  );
}

/** What a narrow screen has no room for. */
function More() {
  return (
    <span class="transport-narrow">
      <PopoverButton label="More" buttonClass="icon-button" side="above" face={<Icon node={Ellipsis} />}>
        {(close) => <TransportItems close={close} />}
      </PopoverButton>
    </span>
  );
}
