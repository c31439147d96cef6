import { Ellipsis } from "lucide";
import { Icon } from "../theme/icons";
import { PopoverButton } from "./controls/popover";
import { lazily } from "./lazily";

const MoreItems = lazily(() => import("./more-items").then((part) => part.MoreItems));

/** The way to what a narrow top bar has no room for. */
export function MoreMenu() {
  return (
    <span class="more">
      <PopoverButton label="Menu" buttonClass="icon-button" side="below-end" face={<Icon node={Ellipsis} size={18} />}>
        {(close) => <MoreItems close={close} />}
      </PopoverButton>
    </span>
  );
}
