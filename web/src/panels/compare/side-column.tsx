import { type Signal, useSignalEffect } from "@preact/signals";
import type { Cost } from "../../document/scene";
import type { SegmentReport } from "../../engine/api";
import type { Playback } from "../../playback/playback";
import type { View } from "../../stage/view";
import { planningView } from "../inspector/planning-view";
import { StatusPill } from "../status";
import { useStudio } from "../studio";
import { SideOptions } from "./side-options";
import { SideStage } from "./side-stage";
import type { TieChoice } from "./side-ties";
import { isInUse, type Side, type SideChange } from "./sides";
import { useTrial } from "./use-trial";

interface SideColumnProps {
  readonly name: string;
  readonly side: Side;
  /** When all ways leave, scene seconds. */
  readonly start: number;
  readonly ties: readonly TieChoice[];
  readonly playback: Playback;
  readonly view: View;
  /** Where its numbers go; null while they are not known. */
  readonly report: Signal<SegmentReport | null>;
  onChange(change: SideChange): void;
  onSeat(cost: Cost): Promise<void>;
  onUse(): void;
}

/** One way: how it is made, how it looks, and the button that takes it over. */
export function SideColumn(props: SideColumnProps) {
  const { name, side, start, ties, playback, view, report, onChange, onSeat, onUse } = props;
  const { document } = useStudio();
  const scene = document.scene.value;
  const trial = useTrial(side, start, playback.time);
  useSignalEffect(() => {
    const planned = trial.planner.segments.value[trial.segment];
    report.value = planned?.kind === "ready" ? planned.plan.report : null;
  });
  const planning = planningView(trial.planner.segments.value[trial.segment], scene.minimumDistance, scene.stage.units);
  return (
    // biome-ignore lint/a11y/useSemanticElements: a stage with its controls is no fieldset.
    <div class="compare-side" role="group" aria-label={name}>
      <SideOptions
        side={side}
        choice={planning.plan?.report.choice ?? side.spec.chosen}
        ties={ties}
        onChange={onChange}
        onSeat={onSeat}
      />
      <SideStage trial={trial} playback={playback} view={view} />
      <div class="compare-foot">
        {planning.words && <StatusPill status={planning.status}>{planning.words}</StatusPill>}
        {planning.problem && <p class="inspector-text">{planning.problem.what}</p>}
        <label class="compare-avoid">
          <input
            type="checkbox"
            class="switch"
            aria-label="Avoid collisions"
            checked={side.spec.avoidance}
            onChange={(event) => onChange({ options: { avoidance: event.currentTarget.checked } })}
          />
          Avoid
        </label>
        <button
          type="button"
          class="button"
          disabled={side.counterpart !== null || isInUse(scene, side)}
          onClick={onUse}
        >
          Use {name.toLowerCase()}
        </button>
      </div>
    </div>
  );
}
