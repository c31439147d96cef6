import { useStudio } from "../studio";
import { planningWords } from "./planning-words";

/** What the engine is at, how far it is, and the way to stop it. */
export function PlanningToast() {
  const { document, planner } = useStudio();
  const { segments, progress: ofAll } = planner;
  const { what, progress, percent } = planningWords(document.scene.value, segments.value, ofAll.value ?? 0);
  return (
    <div class="toast planning">
      <ProgressRibbon progress={progress} />
      <p>
        Planning <strong>{what}</strong> <span class="number unit">{percent}</span>
      </p>
      <button type="button" class="button soft" onClick={() => planner.cancel()}>
        Cancel
      </button>
    </div>
  );
}

/** Work under way, from faint to firm. */
function ProgressRibbon({ progress }: { progress: number }) {
  return (
    <span
      class="progress-ribbon"
      role="progressbar"
      aria-label="Planning"
      aria-valuenow={Math.floor(progress * 100)}
      aria-valuemin={0}
      aria-valuemax={100}
      style={{ "--at": progress }}
    />
  );
}
