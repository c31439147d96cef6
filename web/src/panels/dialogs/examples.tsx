import "./dialogs.css";
import "./examples.css";
import { ExampleTile } from "./example-tile";
import { Frame } from "./frame";
import type { DialogProps } from "./host";
import { useAnswer } from "./use-answer";

/** Scenes to start from, each shown in motion. */
export function ExamplesDialog({ services, dialogs }: DialogProps) {
  const examples = useAnswer(services.loadExamples);
  const previews = useAnswer(services.loadPreviews);
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
      <ul class="gallery">
        {(examples.kind === "here" ? examples.value : []).map((example, index) => (
          <li key={example.id}>
            <ExampleTile
              example={example}
              isFirst={index === 0}
              preview={(previews.kind === "here" && previews.value.get(example.id)) || null}
              onOpen={() => {
                dialogs.close();
                void services.openExample(example);
              }}
            />
          </li>
        ))}
      </ul>
    </Frame>
  );
}
