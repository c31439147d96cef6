import { useEffect } from "preact/hooks";
import { assignPlaces } from "../../document/commands/assign";
import { agentLabel } from "../../document/queries";
import { mainTrack, type Scene } from "../../document/scene";
import { lengthWithUnit } from "../../document/units";
import type { Rest } from "../../engine/api";
import { NumberBox } from "../controls/number-box";
import { Row } from "../controls/row";
import { Segmented } from "../controls/segmented";
import { Slider } from "../controls/slider";
import { Switch } from "../controls/switch";
import { SHARING } from "../inspector/quantities";
import { useStudio } from "../studio";
import { type AssignmentTrial, openTrial } from "./create-trial";
import { LockList } from "./lock-list";
import { type Walks, walksOf, withStays } from "./walks";

const RESTS: readonly { readonly value: Rest; readonly label: string }[] = [
  { value: "leave", label: "Leave" },
  { value: "stay", label: "Stay" },
  { value: "bench", label: "Bench" },
];

/** What may be told, what comes of it, and taking it over as one step. */
export function AssignmentPreview(props: { index: number; trial: AssignmentTrial; onClose(): void }) {
  const { document, messages } = useStudio();
  const { index, trial, onClose } = props;
  const scene = document.scene.value;
  const { keyframes } = mainTrack(scene);
  const [from, to] = [keyframes[index]?.positions, keyframes[index + 1]?.positions];
  const { recipe, isFlipped, isPredicted, rest = "leave" } = trial.question.value;
  const absent = keyframes[index + 1]?.absent ?? [];
  const found = trial.found.value;
  useEffect(() => trial.ask(), [trial, from, to, scene.groups, scene.obstacles, scene.minimumDistance]);
  useOnStage(trial, onClose);
  if (!from || !to) return null;
  const then = found && (rest === "stay" ? withStays(from, to, absent, found) : { to, bends: found.bends });

  function accept(): void {
    if (!found) return;
    document.perform(assignPlaces(index, found.slots, recipe, rest));
    messages.announce("Places assigned");
    onClose();
  }

  return (
    <>
      {recipe.cost === "least-effort" && (
        <Row label="λ" note="way against spacing">
          <span class="quantity">
            <Slider
              label="Lambda"
              value={recipe.lambda}
              quantity={SHARING}
              onPreview={(lambda) => trial.setRecipe({ lambda })}
              onCommit={() => {}}
              onCancel={() => {}}
            />
            <NumberBox
              label="Lambda"
              value={recipe.lambda}
              quantity={SHARING}
              onCommit={(lambda) => trial.setRecipe({ lambda })}
            />
          </span>
        </Row>
      )}
      {absent.length > 0 && (
        <Row label="The rest" note={`${absent.length} without a place`}>
          <Segmented
            label="The rest"
            value={rest}
            choices={RESTS}
            onChoose={(chosen) => trial.setWay({ rest: chosen })}
          />
        </Row>
      )}
      {recipe.cost !== "keep" && (
        <>
          {scene.groups.length > 0 && (
            <Switch
              label="Keep groups together"
              isOn={recipe.keepGroups}
              onToggle={(keepGroups) => trial.setRecipe({ keepGroups })}
            />
          )}
          <Switch
            label="Flip"
            note="mirrored end to end"
            isOn={isFlipped}
            onToggle={(isOn) => trial.setWay({ isFlipped: isOn })}
          />
          {recipe.locks.length > 0 && (
            <Switch
              label="Predict the rest"
              note="as the locked go, so the others"
              isOn={isPredicted}
              onToggle={(isOn) => trial.setWay({ isPredicted: isOn })}
            />
          )}
        </>
      )}
      <WalkLines
        scene={scene}
        now={walksOf(from, to, found?.ownBends)}
        then={then && found && walksOf(from, then.to, then.bends, found.slots)}
      />
      <UnderWay trial={trial} />
      <div class="inspector-buttons">
        <button type="button" class="button" disabled={!found || trial.progress.value !== null} onClick={accept}>
          Accept
        </button>
        <button type="button" class="button" onClick={onClose}>
          Cancel
        </button>
      </div>
      <LockList scene={scene} trial={trial} />
    </>
  );
}

/** What is drawn over the stage is there as long as the preview; Escape closes both. */
function useOnStage(trial: AssignmentTrial, onClose: () => void): void {
  const { aside, view } = useStudio();
  useEffect(() => {
    const before = aside.peek();
    openTrial.value = trial;
    aside.value = { kind: "assignment" };
    view.projection.value = "plan";
    function onKeyDown(event: KeyboardEvent): void {
      if (event.key !== "Escape" || event.defaultPrevented) return;
      event.preventDefault();
      onClose();
    }
    addEventListener("keydown", onKeyDown, true);
    return () => {
      removeEventListener("keydown", onKeyDown, true);
      trial.stop();
      openTrial.value = null;
      if (aside.peek()?.kind === "assignment") aside.value = before;
    };
  }, [trial]);
}

function WalkLines({ scene, now, then }: { scene: Scene; now: Walks; then: Walks | null }) {
  const length = (meters: number) => lengthWithUnit(meters, scene.stage.units, 1);
  const line = ({ total, longest, who }: Walks) =>
    `${length(total)} in all, the longest walk ${length(longest)}${who < 0 ? "" : ` (${agentLabel(scene, who)})`}`;
  return (
    <p class="inspector-text" role="status">
      {then && <>{line(then)}. </>}
      <span class="walks-now">As it is: {line(now)}.</span>
    </p>
  );
}

function UnderWay({ trial }: { trial: AssignmentTrial }) {
  const progress = trial.progress.value;
  if (trial.problem.value) return <p class="inspector-text">{trial.problem.value}</p>;
  if (progress === null) return null;
  const percent = Math.floor(progress * 100);
  return (
    <p class="inspector-text">
      <span
        class="progress-ribbon"
        role="progressbar"
        aria-label="Assigning"
        aria-valuenow={percent}
        aria-valuemin={0}
        aria-valuemax={100}
        style={{ "--at": progress }}
      />{" "}
      {percent} %{" "}
      <button type="button" class="link" onClick={() => trial.stop()}>
        Stop
      </button>
    </p>
  );
}
