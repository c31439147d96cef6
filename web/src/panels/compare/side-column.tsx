import type { TransitionOptions } from "../../document/commands/transitions";
import type { Playback } from "../../playback/playback";
import type { View } from "../../stage/view";
import { planningView } from "../inspector/planning-view";
import { StatusPill } from "../status";
import { useStudio } from "../studio";
import { SideOptions } from "./side-options";
import { SideStage } from "./side-stage";
import { isInUse, type Side, type Trial } from "./sides";
import type { PlannedTrial } from "./use-trial";

interface SideColumnProps {
  readonly name: "Left" | "Right";
  readonly side: Side;
  readonly trial: Trial;
  readonly planned: PlannedTrial;
  readonly playback: Playback;
  readonly view: View;
  onChange(options: TransitionOptions): void;
  onUse(): void;
}

/** One way: how it is made, how it looks, and the button that takes it over. */
export function SideColumn({ name, side, trial, planned, playback, view, onChange, onUse }: SideColumnProps) {
  const { document } = useStudio();
  const scene = document.scene.value;
  const planning = planningView(
    planned.planner.segments.value[trial.segment],
    scene.minimumDistance,
    scene.stage.units,
  );
  return (
    // biome-ignore lint/a11y/useSemanticElements: a stage with its controls is no fieldset.
    <div class="compare-side" role="group" aria-label={name}>
      <SideOptions spec={side.spec} choice={planning.plan?.report.choice ?? side.spec.chosen} onChange={onChange} />
      <SideStage trial={planned} playback={playback} view={view} />
      <div class="compare-foot">
        {planning.words && <StatusPill status={planning.status}>{planning.words}</StatusPill>}
        {planning.problem && <p class="inspector-text">{planning.problem.what}</p>}
        <button type="button" class="button" disabled={isInUse(scene, side)} onClick={onUse}>
          Use {name.toLowerCase()}
        </button>
      </div>
    </div>
  );
}
