import { useState } from "preact/hooks";
import { useStudio } from "../studio";
import { undidScene } from "./field-undo";

/** A line of text, taken over on Enter and on leaving; Escape leaves it as it was. */
export function TextBox(props: {
  label: string;
  value: string;
  placeholder?: string;
  maxLength: number;
  onCommit(text: string): void;
}) {
  const { actions } = useStudio();
  const [draft, setDraft] = useState<string | null>(null);
  function commit(): void {
    setDraft(null);
    if (draft !== null && draft !== props.value) props.onCommit(draft);
  }
  return (
    <input
      class="text-box"
      aria-label={props.label}
      placeholder={props.placeholder}
      maxLength={props.maxLength}
      autocomplete="off"
      spellcheck={false}
      value={draft ?? props.value}
      onInput={(event) => setDraft(event.currentTarget.value)}
      onBlur={commit}
      onKeyDown={(event) => {
        if (draft === null && undidScene(event, actions)) return;
        if (event.key === "Enter") commit();
        if (event.key === "Escape") setDraft(null);
      }}
    />
  );
}
