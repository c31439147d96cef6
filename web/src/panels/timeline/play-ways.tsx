import { Repeat } from "lucide";
import { Icon } from "../../theme/icons";
import { useStudio } from "../studio";
import { keyName, keyShortcuts, useAction } from "../use-action";
import { SpeedMenu } from "./speed-menu";

/** How the show plays: again and again, how fast, and counted how. */
export function PlayWays() {
  return (
    <>
      <LoopButton />
      <SpeedMenu />
      <CountsButton />
    </>
  );
}

function LoopButton() {
  const { playback } = useStudio();
  const { action } = useAction("loop");
  return (
    <button
      type="button"
      class="icon-button"
      aria-label="Loop"
      aria-pressed={playback.isLooping.value}
      aria-keyshortcuts={keyShortcuts(action.keys)}
      data-tip={playback.range.value ? "Loop the marked range" : "Loop"}
      data-tip-side="top"
      data-keys={action.keys[0] && keyName(action.keys[0])}
      onClick={() => action.run()}
    >
      <Icon node={Repeat} />
    </button>
  );
}

/** Whether the ruler, the clock and a drag go by counts. */
function CountsButton() {
  const { view } = useStudio();
  const { action } = useAction("counts");
  return (
    <button
      type="button"
      class="toggle"
      aria-label="Counts"
      aria-pressed={view.ruler.value === "counts"}
      data-tip="Counts and bars instead of seconds"
      data-tip-side="top"
      onClick={() => action.run()}
    >
      Counts
    </button>
  );
}
