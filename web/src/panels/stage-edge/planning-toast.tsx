import { keyframeLabel } from "../../document/queries";
import { formatCount } from "../../document/units";
import { useStudio } from "../studio";

/** What the engine is at, how far it is, and the way to stop it. */
export function PlanningToast() {
  const { document, planner } = useStudio();
  const scene = document.scene.value;
  const planned = planner.segments.value.flatMap((segment, index) => (segment.kind === "planning" ? [index] : []));
  const [only] = planned;
  const progress = planner.progress.value ?? 0;
  return (
    <div class="toast planning">
      <ProgressRibbon progress={progress} />
      <p>
        Planning{" "}
        <strong>
          {planned.length === 1 && only !== undefined
            ? `${keyframeLabel(scene, only)} → ${keyframeLabel(scene, only + 1)}`
            : `${formatCount(planned.length)} transitions`}
        </strong>{" "}
        <span class="number unit">{Math.floor(progress * 100)} %</span>
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
