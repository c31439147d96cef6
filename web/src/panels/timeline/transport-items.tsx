import { Copy, Trash2 } from "lucide";
import { Icon } from "../../theme/icons";
import { useAction } from "../use-action";
import { PlayWays } from "./play-ways";

/** What the row of the transport has no room for on a narrow screen, one below the other. */
export function TransportItems({ close }: { close(): void }) {
  const duplicate = useAction("duplicate-keyframe");
  const remove = useAction("delete-keyframe");
  return (
    <div class="menu">
      <button type="button" class="menu-item" onClick={() => [close(), duplicate.action.run()]}>
        <Icon node={Copy} />
        Duplicate keyframe
      </button>
      <button
        type="button"
        class="menu-item"
        disabled={!remove.isEnabled}
        onClick={() => [close(), remove.action.run()]}
      >
        <Icon node={Trash2} />
        Delete keyframe
      </button>
      <hr class="menu-line" />
      <div class="menu-row">
        <PlayWays />
      </div>
    </div>
  );
}
