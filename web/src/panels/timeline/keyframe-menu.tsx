import { ArrowLeft, ArrowLeftRight, ArrowRight, Copy, type IconNode, Repeat2, Trash2 } from "lucide";
import { useLayoutEffect, useRef } from "preact/hooks";
import { reorderKeyframe } from "../../document/commands/keyframes";
import { selectedRun } from "../../document/run";
import { mainTrack } from "../../document/scene";
import { Icon } from "../../theme/icons";
import { placeBeside } from "../controls/place-beside";
import { moveFocus } from "../roving";
import { useStudio } from "../studio";

export interface KeyframeMenuProps {
  readonly index: number;
  /** What it opens beside. */
  readonly anchor: HTMLElement;
  /** After something was chosen, or not; `moved` is where the keyframe went, null when it stayed. */
  onClose(moved: number | null): void;
}

/** What can be done with a keyframe, for those who do not drag. */
export function KeyframeMenu({ index, anchor, onClose }: KeyframeMenuProps) {
  const { document, actions } = useStudio();
  const menu = useRef<HTMLDivElement>(null);
  const last = mainTrack(document.scene.value).keyframes.length - 1;
  const isRun = selectedRun(document.selection.value) !== null;

  useLayoutEffect(() => {
    const panel = menu.current;
    if (!panel) return;
    panel.showPopover();
    placeBeside(panel, anchor, "above");
    panel.querySelector<HTMLElement>("button:enabled")?.focus();
  }, [anchor]);

  const reorder = (to: number) => () => {
    document.perform(reorderKeyframe(index, to));
    onClose(to);
  };
  const act = (id: string) => () => {
    onClose(null);
    actions.get(id).run();
  };

  return (
    <div
      ref={menu}
      class="popover menu"
      popover="auto"
      role="menu"
      aria-label="Keyframe"
      onToggle={(event) => {
        if (event.newState === "closed") onClose(null);
      }}
      onKeyDown={(event) => moveFocus(event, "button")}
    >
      <Item words="Move earlier" keys="Alt ←" node={ArrowLeft} isOff={index === 0} run={reorder(index - 1)} />
      <Item words="Move later" keys="Alt →" node={ArrowRight} isOff={index === last} run={reorder(index + 1)} />
      <hr class="menu-line" />
      <Item words="Duplicate" keys="" node={Copy} isOff={false} run={act("duplicate-keyframe")} />
      <Item words="Delete" keys="Del" node={Trash2} isOff={last === 0} run={act("delete-keyframe")} />
      {isRun && (
        <>
          <hr class="menu-line" />
          <Item words="Reverse run" keys="" node={ArrowLeftRight} isOff={false} run={act("reverse-run")} />
          <Item words="Repeat run" keys="" node={Repeat2} isOff={false} run={act("repeat-run")} />
        </>
      )}
    </div>
  );
}

function Item(props: { words: string; keys: string; node: IconNode; isOff: boolean; run: () => void }) {
  return (
    <button type="button" role="menuitem" class="menu-item" disabled={props.isOff} onClick={props.run}>
      <Icon node={props.node} />
      {props.words}
      {props.keys && <span class="keys">{props.keys}</span>}
    </button>
  );
}
