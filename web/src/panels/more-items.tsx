import { WordAction } from "./action-button";
import { LayerToggles } from "./stage-edge/layer-toggles";
import { ProjectionSwitch } from "./stage-edge/view-pills";
import { useStudio } from "./studio";
import { useIsDark } from "./use-is-dark";

/** What the top bar has no room for on a narrow screen, one below the other. */
export function MoreItems({ close }: { close(): void }) {
  const { document } = useStudio();
  const isDark = useIsDark();
  const redo = document.redoLabel.value;
  return (
    <div class="menu more-menu">
      <WordAction id="new" class="menu-item" onDone={close}>
        New
      </WordAction>
      <WordAction id="examples" class="menu-item" onDone={close}>
        Examples
      </WordAction>
      <WordAction id="open" class="menu-item" onDone={close}>
        Open
      </WordAction>
      <WordAction id="save" class="menu-item" onDone={close}>
        Save
      </WordAction>
      <WordAction id="export" class="menu-item" onDone={close}>
        Export
      </WordAction>
      <div class="only-on-phone">
        <hr class="menu-line" />
        <WordAction id="redo" class="menu-item" onDone={close}>
          Redo {redo && <span class="keys">{redo}</span>}
        </WordAction>
        <WordAction id="fit" class="menu-item" onDone={close}>
          Fit
        </WordAction>
        <WordAction id="palette" class="menu-item" onDone={close}>
          Commands
        </WordAction>
        <WordAction id="help" class="menu-item" onDone={close}>
          Help
        </WordAction>
        <WordAction id="theme" class="menu-item" onDone={close}>
          {isDark ? "Light theme" : "Dark theme"}
        </WordAction>
        <hr class="menu-line" />
        <ProjectionSwitch />
        <LayerToggles />
      </div>
    </div>
  );
}
