import type { TransitionOptions } from "../../document/commands/transitions";
import type { Choice, Segment } from "../../document/scene";
import { Select } from "../controls/select";
import { optionsShown, takenOver } from "./options-shown";
import { ALIGNMENTS, METHODS, methodWord, ORDERS } from "./words";

interface OptionProps {
  readonly spec: Segment;
  /** What the motion was made by; null until it is known. */
  readonly choice: Choice | null;
  onChange(options: TransitionOptions): void;
}

export function MethodSelect({ spec, choice, onChange }: OptionProps) {
  return (
    <Select
      label="Method"
      value={spec.method}
      choices={METHODS}
      detail={spec.method === "auto" && choice ? `chose ${methodWord(choice.method)}` : undefined}
      onChoose={(method) => onChange({ method })}
    />
  );
}

export function OrderSelect({ spec, choice, onChange }: OptionProps) {
  return (
    <Select
      label="Order"
      value={optionsShown(spec, choice).order}
      choices={ORDERS}
      detail={byAuto(spec, choice?.method === "spectral")}
      onChoose={(order) => onChange(takenOver(spec, choice, { order }))}
    />
  );
}

export function AlignmentSelect({ spec, choice, onChange }: OptionProps) {
  return (
    <Select
      label="Alignment"
      value={optionsShown(spec, choice).alignment}
      choices={ALIGNMENTS}
      detail={byAuto(spec, choice !== null && choice.method !== "linear")}
      onChoose={(alignment) => onChange(takenOver(spec, choice, { alignment }))}
    />
  );
}

function byAuto(spec: Segment, isUsed: boolean): string | undefined {
  return spec.method === "auto" && isUsed ? "by auto" : undefined;
}
