import type { IconNode } from "lucide";
import type { ComponentChildren } from "preact";
import { Icon } from "../theme/icons";
import type { ActionId } from "./shortcuts";
import { keyName, keyShortcuts, useAction } from "./use-action";

/** Where a name appears beside its icon. */
export type TipSide = "below" | "right" | "top" | "end";

/** An action as an icon, with its name and key on hover. */
export function IconAction(props: {
  id: ActionId;
  icon: IconNode;
  /** When not the action's own label. */
  name?: string;
  /** More than the name, for those who hover: what undo would take back. */
  tip?: string;
  side?: TipSide;
  size?: 14 | 16;
  /** Its own press may end what it is for: the focus stays with it. */
  keepsFocus?: boolean;
}) {
  const { action, isEnabled } = useAction(props.id);
  const name = props.name ?? action.label;
  const [key] = action.keys;
  return (
    <button
      type="button"
      class="icon-button"
      aria-label={name}
      aria-keyshortcuts={keyShortcuts(action.keys)}
      disabled={!isEnabled && !props.keepsFocus}
      aria-disabled={props.keepsFocus && !isEnabled}
      data-tip={props.tip ?? name}
      data-tip-side={props.side}
      data-keys={key && keyName(key)}
      onClick={() => isEnabled && action.run()}
    >
      <Icon node={props.icon} size={props.size ?? 16} />
    </button>
  );
}

/** An action as a word. */
export function WordAction(props: { id: ActionId; class: string; children: ComponentChildren; onDone?(): void }) {
  const { action, isEnabled } = useAction(props.id);
  const [key] = action.keys;
  return (
    <button
      type="button"
      class={props.class}
      disabled={!isEnabled}
      aria-keyshortcuts={keyShortcuts(action.keys)}
      title={key && `${action.label} (${keyName(key)})`}
      onClick={() => {
        props.onDone?.();
        action.run();
      }}
    >
      {props.children}
    </button>
  );
}
