import { useState } from "preact/hooks";
import type { TransitionOptions } from "../../document/commands/transitions";
import type { Choice, Cost } from "../../document/scene";
import type { Counterpart } from "../../engine/api";
import { NumberBox } from "../controls/number-box";
import { Select } from "../controls/select";
import { AlignmentSelect, MethodSelect, OrderSelect } from "../inspector/option-selects";
import { optionsShown, takenOver } from "../inspector/options-shown";
import { SHARING } from "../inspector/quantities";
import { COSTS } from "./run/run-words";
import type { TieChoice } from "./side-ties";
import type { Side, SideChange } from "./sides";

const TIES: readonly { value: TieChoice; label: string }[] = [
  { value: "own", label: "As tied" },
  { value: "proposed", label: "As proposed" },
  { value: "grouped", label: "Groups ×10" },
];

const OWN = "own";

const KEPT_APART: readonly { value: Counterpart | typeof OWN; label: string }[] = [
  { value: OWN, label: "As it says" },
  { value: "social-force-guide", label: "Social force on its way" },
  { value: "social-force", label: "Social force alone" },
  { value: "orca", label: "ORCA alone" },
];

/** The method of one way and what it can be told, in a line. */
export function SideOptions(props: {
  side: Side;
  choice: Choice | null;
  /** Ties that make a difference here. */
  ties: readonly TieChoice[];
  onChange(change: SideChange): void;
  /** Finds places by a cost. */
  onSeat(cost: Cost): Promise<void>;
}) {
  const { side, choice, ties, onChange, onSeat } = props;
  const [sought, setSought] = useState<Cost | null>(null);
  const { spec } = side;
  const shown = optionsShown(spec, choice);
  const isAuto = spec.method === "auto";
  const option = { spec, choice, onChange: (options: TransitionOptions) => onChange({ options }) };
  return (
    <div class="compare-options">
      <MethodSelect {...option} />
      {!isAuto && shown.hasOrder && <OrderSelect {...option} />}
      {!isAuto && shown.hasAlignment && <AlignmentSelect {...option} />}
      {!isAuto && shown.hasSharing && (
        <NumberBox
          label="Sharing"
          prefix="ρ"
          value={shown.sharing}
          quantity={SHARING}
          onCommit={(sharing) => option.onChange(takenOver(spec, choice, { sharing }))}
        />
      )}
      <Select
        label="Kept apart"
        value={side.counterpart ?? OWN}
        choices={KEPT_APART}
        onChoose={(way) => onChange({ counterpart: way === OWN ? null : way })}
      />
      <Select
        label="Assignment"
        value={sought ?? side.seating?.cost ?? "keep"}
        choices={COSTS.map(({ cost, label }) => ({ value: cost, label }))}
        isDisabled={sought !== null}
        onChoose={(cost) => {
          setSought(cost);
          void onSeat(cost).finally(() => setSought(null));
        }}
      />
      {ties.length > 1 && (
        <Select
          label="Ties"
          value={side.ties}
          choices={TIES.filter(({ value }) => ties.includes(value))}
          onChoose={(chosen) => onChange({ ties: chosen })}
        />
      )}
    </div>
  );
}
