import "./top-bar.css";
import type { ReadonlySignal } from "@preact/signals";
import { CircleQuestionMark, type IconNode, Moon, Redo2, Search, Sun, Undo2 } from "lucide";
import { Icon } from "../theme/icons";
import { Mark } from "../theme/mark";
import { useStudio } from "./studio";
import { TitleField } from "./title-field";
import { keyName, keyShortcuts, useAction } from "./use-action";

/** Whose scene it is, where it is kept, and what can be done with the whole. */
export function TopBar({ savedText }: { savedText: ReadonlySignal<string> }) {
  const { document } = useStudio();
  return (
    <header class="top">
      <Mark />
      <h1 class="unseen">Eigenform</h1>
      <TitleField />
      <span class="saved">{savedText}</span>
      <span class="separator" />
      <IconAction id="undo" node={Undo2} name="Undo" what={document.undoLabel.value} />
      <IconAction id="redo" node={Redo2} name="Redo" what={document.redoLabel.value} />
      <span class="grow" />
      <nav class="words" aria-label="Scene">
        <WordAction id="new" name="New" />
        <WordAction id="examples" name="Examples" />
        <WordAction id="open" name="Open" />
        <WordAction id="save" name="Save" />
        <WordAction id="export" name="Export" />
      </nav>
      <span class="separator" />
      <IconAction id="palette" node={Search} name="Commands" />
      <IconAction id="help" node={CircleQuestionMark} name="Help" />
      <ThemeButton />
      <ShareButton />
    </header>
  );
}

function WordAction({ id, name }: { id: string; name: string }) {
  const { action, isEnabled } = useAction(id);
  return (
    <button
      type="button"
      class="button quiet"
      disabled={!isEnabled}
      aria-keyshortcuts={keyShortcuts(action.keys)}
      data-tip={action.keys[0] ? action.label : undefined}
      data-keys={action.keys[0] && keyName(action.keys[0])}
      onClick={action.run}
    >
      {name}
    </button>
  );
}

function IconAction(props: { id: string; node: IconNode; name: string; what?: string | null }) {
  const { action, isEnabled } = useAction(props.id);
  const key = action.keys[0];
  return (
    <button
      type="button"
      class="icon-button"
      aria-label={props.name}
      aria-keyshortcuts={keyShortcuts(action.keys)}
      disabled={!isEnabled}
      data-tip={props.what ? `${props.name}: ${props.what}` : props.name}
      data-keys={key && keyName(key)}
      onClick={action.run}
    >
      <Icon node={props.node} />
    </button>
  );
}

function ThemeButton() {
  const { view } = useStudio();
  const isDark =
    view.theme.value === "dark" ||
    (view.theme.value === "system" && matchMedia("(prefers-color-scheme: dark)").matches);
  const name = isDark ? "Light theme" : "Dark theme";
  return (
    <button
      type="button"
      class="icon-button"
      aria-label={name}
      data-tip={name}
      onClick={() => {
        view.theme.value = isDark ? "light" : "dark";
      }}
    >
      <Icon node={isDark ? Sun : Moon} />
    </button>
  );
}

function ShareButton() {
  const { action, isEnabled } = useAction("share");
  return (
    <button type="button" class="button primary share" disabled={!isEnabled} onClick={action.run}>
      Share
    </button>
  );
}
