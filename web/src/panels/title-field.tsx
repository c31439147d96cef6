import { useComputed } from "@preact/signals";
import { NOT_LOADED } from "./messages";
import { useStudio } from "./studio";

/** The scene's title, edited in place. */
export function TitleField() {
  const { document, messages } = useStudio();
  // Drawn anew by another title alone: what is being typed outlives whatever else changes in the scene.
  const title = useComputed(() => document.scene.value.title).value;

  const rename = (to: string) => {
    import("../document/commands/scene").then(
      ({ setTitle }) => document.perform(setTitle(to)),
      () => messages.say(NOT_LOADED),
    );
  };

  return (
    <input
      class="title"
      aria-label="Title"
      placeholder="Untitled"
      maxLength={200}
      spellcheck={false}
      autocomplete="off"
      value={title}
      size={Math.max(8, title.length)}
      onKeyDown={(event) => {
        if (event.key === "Enter") event.currentTarget.blur();
        if (event.key === "Escape") {
          event.currentTarget.value = title;
          event.currentTarget.blur();
        }
      }}
      onChange={(event) => rename(event.currentTarget.value)}
    />
  );
}
