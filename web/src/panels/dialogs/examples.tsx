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

  const sections = examples.kind === "here" ? examples.value : [];

  async function open(example: ExampleCard, view?: OpenedView): Promise<void> {
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
      {examples.kind === "refused" && (
        <p class="dialog-text" role="status">
          The examples could not be loaded: {examples.problem.what}
        </p>
      )}
      <nav class="gallery-ways" aria-label="Sections">
        {sections.map(({ title }) => (
          <button key={title} type="button" class="button quiet" onClick={(event) => goTo(event.currentTarget, title)}>
            {title}
          </button>
        ))}
      </nav>
      {sections.map(({ title, source, cards }, place) => (
        <section key={title} class="gallery-section" aria-label={title}>
          <h3>
            {title}
            {source && <small>{source}</small>}
          </h3>
          <ul class="gallery">
            {cards.map((example, index) => (
              <li key={example.id}>
                <ExampleTile
                  example={example}
                  isFirst={place === 0 && index === 0}
                  loadPreview={services.loadPreview}
                  onOpen={() => void open(example)}
                />
                {waysIn(example).map(({ words, view }) => (
                  <button
                    key={words}
                    type="button"
                    class="button example-view"
                    aria-label={`${words}: ${example.title}`}
                    onClick={() => void open(example, view)}
                  >
                    {words}
                  </button>
                ))}
              </li>
            ))}
          </ul>
        </section>
      ))}
    </Frame>
  );
}

/** The section comes to the top, and its first card has the focus. */
function goTo(link: HTMLElement, title: string): void {
  const section = link.closest("dialog")?.querySelector(`section[aria-label="${title}"]`);
  section?.scrollIntoView({ block: "start" });
  section?.querySelector<HTMLElement>(".example")?.focus({ preventScroll: true });
}

/** A view as it is opened: of a comparison, with the ways beside each other or with the table. */
type OpenedView = ExampleView & { readonly isTable?: boolean };

/** What an example can be opened with at once, beside being played. */
function waysIn({ view }: ExampleCard): readonly { readonly words: string; readonly view: OpenedView }[] {
  if (view?.kind === "modes") return [{ words: "See its modes", view }];
  if (view?.kind !== "compare") return [];
  const sides = view.preset
    ? "Compare side by side"
    : view.segments.length > 2
      ? "Compare all ways"
      : "Compare both ways";
  const table = { words: "Table and plots", view: { ...view, isTable: true } };
  return [{ words: sides, view }, ...(view.table ? [table] : [])];
}
