import "./top-bar.css";
import type { ReadonlySignal } from "@preact/signals";
import { CircleQuestionMark, Moon, Redo2, Search, Sun, Undo2 } from "lucide";
import { Mark } from "../theme/mark";
import { IconAction, WordAction } from "./action-button";
import { MoreMenu } from "./more-menu";
import { useStudio } from "./studio";
import { TitleField } from "./title-field";
import { useIsDark } from "./use-is-dark";

/** Whose scene it is, where it is kept, and what can be done with the whole. */
export function TopBar({ savedText }: { savedText: ReadonlySignal<string> }) {
  const { document } = useStudio();
  const { undoLabel, redoLabel } = document;
  return (
    <header class="top">
      <Mark />
      <h1 class="unseen">Eigenform</h1>
      <TitleField />
      <span class="saved">{savedText}</span>
      <span class="separator" />
      <IconAction id="undo" icon={Undo2} tip={undoLabel.value ? `Undo: ${undoLabel.value}` : "Undo"} />
      <span class="not-on-phone">
        <IconAction id="redo" icon={Redo2} tip={redoLabel.value ? `Redo: ${redoLabel.value}` : "Redo"} />
      </span>
      <span class="grow" />
      <nav class="words" aria-label="Scene">
        <WordAction id="new" class="button quiet">
          New
        </WordAction>
        <WordAction id="examples" class="button quiet">
          Examples
        </WordAction>
        <WordAction id="open" class="button quiet">
          Open
        </WordAction>
        <WordAction id="save" class="button quiet">
          Save
        </WordAction>
        <WordAction id="export" class="button quiet">
          Export
        </WordAction>
      </nav>
      <span class="separator" />
      <span class="not-on-phone">
        <IconAction id="palette" icon={Search} />
        <IconAction id="help" icon={CircleQuestionMark} />
        <ThemeButton />
      </span>
      <WordAction id="share" class="button primary share">
        Share
      </WordAction>
      <MoreMenu />
    </header>
  );
}

function ThemeButton() {
  const isDark = useIsDark();
  return <IconAction id="theme" icon={isDark ? Sun : Moon} name={isDark ? "Light theme" : "Dark theme"} />;
}
