import "./dialogs.css";
import "./examples.css";
import { useStudio } from "../studio";
import { ExampleTile } from "./example-tile";
import { Frame } from "./frame";
import type { DialogProps } from "./host";
import type { ExampleCard, ExampleView } from "./services";
import { useAnswer } from "./use-answer";

/** Scenes to start from, each shown in motion, and what some of them are best looked at with. */
export function ExamplesDialog({ services, dialogs }: DialogProps) {
  const { document, aside } = useStudio();
  const examples = useAnswer(services.loadExamples);
  const previews = useAnswer(services.loadPreviews);

  async function open(example: ExampleCard, view?: ExampleView): Promise<void> {
    dialogs.close();
    const isOpen = await services.openExample(example);
    if (!isOpen || !view) return;
    if (view.kind === "compare") dialogs.show(view);
    if (view.kind === "modes") {
      document.selection.value = { kind: "transition", index: view.segment };
      aside.value = { kind: "modes" };
    }
  }

  return (
    <Frame
      title="Start from an example"
      size="large"
      lead="It opens as your own copy. Your current scene stays one undo away."
      onClose={dialogs.close}
    >
      {previews.kind === "refused" && (
        <p class="dialog-text" role="status">
          The pictures could not be loaded: {previews.problem.what}
        </p>
      )}
      {sectionsOf(examples.kind === "here" ? examples.value : []).map(([section, cards], place) => (
        <section key={section} class="gallery-section" aria-label={section}>
          <h3>{section}</h3>
          <ul class="gallery">
            {cards.map((example, index) => (
              <li key={example.id}>
                <ExampleTile
                  example={example}
                  isFirst={place === 0 && index === 0}
                  preview={(previews.kind === "here" && previews.value.get(example.id)) || null}
                  onOpen={() => void open(example)}
                />
                {example.view && example.view.kind !== "recording" && (
                  <button
                    type="button"
                    class="button example-view"
                    aria-label={`${VIEW_WORDS[example.view.kind]}: ${example.title}`}
                    onClick={() => void open(example, example.view)}
                  >
                    {VIEW_WORDS[example.view.kind]}
                  </button>
                )}
              </li>
            ))}
          </ul>
        </section>
      ))}
    </Frame>
  );
}

const VIEW_WORDS: Readonly<Record<Exclude<ExampleView["kind"], "recording">, string>> = {
  compare: "Compare both ways",
  modes: "See its modes",
};

/** Cards by section, in the order in which the sections first occur. */
function sectionsOf(cards: readonly ExampleCard[]): [section: string, cards: ExampleCard[]][] {
  const sections = new Map<string, ExampleCard[]>();
  for (const card of cards) sections.set(card.section, [...(sections.get(card.section) ?? []), card]);
  return [...sections];
}
