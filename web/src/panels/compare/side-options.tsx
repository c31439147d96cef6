import type { TransitionOptions } from "../../document/commands/transitions";
import type { Choice, Segment } from "../../document/scene";
import { NumberBox } from "../controls/number-box";
import { Select } from "../controls/select";
import { optionsShown, takenOver } from "../inspector/options-shown";
import { SHARING } from "../inspector/quantities";
import { ALIGNMENTS, METHODS, methodWord, ORDERS } from "../inspector/words";

/** The method of one side and what it can be told, in a line. */
export function SideOptions(props: {
  spec: Segment;
  choice: Choice | null;
  onChange(options: TransitionOptions): void;
}) {
  const { spec, choice, onChange } = props;
  const shown = optionsShown(spec, choice);
  const isAuto = spec.method === "auto";
  return (
    <div class="compare-options">
      <Select
        label="Method"
        value={spec.method}
        choices={METHODS}
        detail={isAuto && choice ? `chose ${methodWord(choice.method)}` : undefined}
        onChoose={(method) => onChange({ method })}
      />
      {!isAuto && shown.hasOrder && (
        <Select
          label="Order"
          value={shown.order}
          choices={ORDERS}
          onChoose={(order) => onChange(takenOver(spec, choice, { order }))}
        />
      )}
      {!isAuto && shown.hasAlignment && (
        <Select
          label="Alignment"
          value={shown.alignment}
          choices={ALIGNMENTS}
          onChoose={(alignment) => onChange(takenOver(spec, choice, { alignment }))}
        />
      )}
      {!isAuto && shown.hasSharing && (
        <NumberBox
          label="Sharing"
          prefix="ρ"
          value={shown.sharing}
          quantity={SHARING}
          onCommit={(sharing) => onChange(takenOver(spec, choice, { sharing }))}
        />
      )}
    </div>
  );
}
