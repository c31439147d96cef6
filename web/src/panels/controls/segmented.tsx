import { useId } from "preact/hooks";
import type { Choice } from "./select";

/** One of a few, all in sight. */
export function Segmented<T extends string>(props: {
  label: string;
  value: T;
  choices: readonly Choice<T>[];
  onChoose(value: T): void;
}) {
  const name = useId();
  return (
    <div class="segmented" role="radiogroup" aria-label={props.label}>
      {props.choices.map((choice) => (
        <label key={choice.value}>
          <input
            type="radio"
            class="overlaid"
            name={name}
            value={choice.value}
            checked={choice.value === props.value}
            onChange={() => props.onChoose(choice.value)}
          />
          <span>{choice.label}</span>
        </label>
      ))}
    </div>
  );
}
