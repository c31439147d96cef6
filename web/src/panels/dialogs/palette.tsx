import "./dialogs.css";
import "./palette.css";
import { Search } from "lucide";
import { useEffect, useMemo, useRef, useState } from "preact/hooks";
import { Icon } from "../../theme/icons";
import { useStudio } from "../studio";
import { keyName } from "../use-action";
import { Modal } from "./frame";
import type { DialogProps } from "./host";
import { type Found, findEntries, paletteEntries } from "./palette-entries";

/** Everything by its name: type, choose with the arrows, Enter does it. */
export function PaletteDialog({ dialogs }: DialogProps) {
  const studio = useStudio();
  const entries = useMemo(() => paletteEntries(studio), [studio]);
  const [typed, setTyped] = useState(dialogs.takeTyped);
  const [at, setAt] = useState(0);
  const list = useRef<HTMLDivElement>(null);
  const sections = findEntries(entries, typed);
  const flat = sections.flatMap((section) => section.entries);
  const chosen = flat[Math.min(at, flat.length - 1)];

  useEffect(() => {
    list.current?.querySelector("[aria-selected=true]")?.scrollIntoView({ block: "nearest" });
  }, [chosen?.id]);

  const run = (entry: Found | undefined) => {
    if (!entry) return;
    // Closed first, so that an action that opens a dialog is not closed with the palette.
    dialogs.close();
    entry.run();
  };

  return (
    <Modal class="dialog palette" label="Commands" onClose={dialogs.close}>
      <div class="palette-head">
        <Icon node={Search} />
        <input
          class="palette-input"
          role="combobox"
          aria-label="Search commands"
          aria-expanded="true"
          aria-controls="palette-list"
          aria-activedescendant={chosen && optionId(chosen)}
          aria-autocomplete="list"
          placeholder="What do you want to do?"
          autofocus
          autocomplete="off"
          spellcheck={false}
          value={typed}
          onInput={(event) => {
            setTyped(event.currentTarget.value);
            setAt(0);
          }}
          onKeyDown={(event) => {
            const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
            if (step !== undefined && flat.length > 0)
              setAt((Math.min(at, flat.length - 1) + step + flat.length) % flat.length);
            else if (event.key === "Enter") run(chosen);
            else return;
            event.preventDefault();
          }}
        />
        <kbd class="key">Esc</kbd>
      </div>
      <div ref={list} id="palette-list" class="palette-list" role="listbox" aria-label="Commands found">
        {sections.map(({ section, entries: found }) => (
          // biome-ignore lint/a11y/useSemanticElements: a group of options in a listbox is no fieldset.
          <div key={section} role="group" aria-label={section}>
            <div class="palette-section" aria-hidden="true">
              {section}
            </div>
            {found.map((entry) => (
              // biome-ignore lint/a11y/useKeyWithClickEvents: the keys go to the input, which points here.
              <div
                key={entry.id}
                id={optionId(entry)}
                class="palette-option"
                role="option"
                tabIndex={-1}
                aria-selected={entry === chosen}
                onPointerMove={() => setAt(flat.indexOf(entry))}
                onClick={() => run(entry)}
              >
                <span>
                  {entry.parts.map((part, index) => (part.isMatch ? <b key={index}>{part.text}</b> : part.text))}
                </span>
                {entry === chosen ? (
                  <kbd class="key">↵</kbd>
                ) : (
                  entry.keys && <kbd class="key">{keyName(entry.keys)}</kbd>
                )}
              </div>
            ))}
          </div>
        ))}
      </div>
      {flat.length === 0 && <p class="palette-none">Nothing is called that. Try another word.</p>}
    </Modal>
  );
}

function optionId(entry: Found): string {
  return `palette-${entry.id}`;
}
