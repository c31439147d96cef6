import { useSignal } from "@preact/signals";
import { FIRST_RECIPE } from "../../document/commands/assign";
import type { Cost, Segment } from "../../document/scene";
import { Row } from "../controls/row";
import { Select } from "../controls/select";
import { Section } from "../inspector/section";
import { useStudio } from "../studio";
import { AssignmentPreview } from "./assignment-preview";
import { type AssignmentTrial, createTrial } from "./create-trial";

const COSTS: readonly { readonly value: Cost; readonly label: string }[] = [
  { value: "keep", label: "Keep" },
  { value: "squared", label: "Squared" },
  { value: "least-effort", label: "Least effort" },
  { value: "euclidean", label: "Euclidean" },
  { value: "manhattan", label: "Manhattan" },
];

/** Who goes where in a transition: how it was found, and, once another way is chosen, what that would make of it. */
export function AssignmentPart({ index, segment }: { index: number; segment: Segment }) {
  const { document, engine, playback } = useStudio();
  const trial = useSignal<AssignmentTrial | null>(null);
  const recipe = trial.value?.question.value.recipe ?? segment.assignment ?? FIRST_RECIPE;

  function choose(cost: Cost): void {
    if (trial.value) {
      trial.value.setRecipe({ cost });
      return;
    }
    playback.pause();
    const begun = createTrial(
      index,
      { ...recipe, cost },
      { scene: () => document.scene.peek(), find: engine.findPlaces, stop: engine.stopErrand },
    );
    trial.value = begun;
  }

  return (
    <Section>
      <Row label="Assignment">
        <Select label="Assignment" value={recipe.cost} choices={COSTS} onChoose={choose} />
      </Row>
      {trial.value ? (
        <AssignmentPreview
          index={index}
          trial={trial.value}
          onClose={() => {
            trial.value = null;
          }}
        />
      ) : (
        <div class="inspector-buttons">
          <button type="button" class="button" onClick={() => choose(recipe.cost)}>
            Who goes where
          </button>
        </div>
      )}
    </Section>
  );
}
