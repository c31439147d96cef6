import { ChevronDown } from "lucide";
import { Icon } from "../../theme/icons";

export interface Choice<T extends string> {
  readonly value: T;
  readonly label: string;
}

/**
 * One of several, by the platform's own list. What is shown may say more than the option: `Auto` and, paler, `chose
 * Spectral`.
 */
export function Select<T extends string>(props: {
  label: string;
  value: T;
  choices: readonly Choice<T>[];
  detail?: string | undefined;
  isDisabled?: boolean;
  onChoose(value: T): void;
}) {
  const shown = props.choices.find((choice) => choice.value === props.value);
  return (
    <span class="select">
      <select
        aria-label={props.label}
        value={props.value}
        disabled={props.isDisabled ?? false}
        onChange={(event) => {
          const chosen = props.choices[event.currentTarget.selectedIndex];
          if (chosen) props.onChoose(chosen.value);
        }}
      >
        {props.choices.map((choice) => (
          <option key={choice.value} value={choice.value}>
            {choice.label}
          </option>
        ))}
      </select>
      <span class="select-face" aria-hidden="true">
        <span>
          {shown?.label} {props.detail && <em>{props.detail}</em>}
        </span>
        <Icon node={ChevronDown} size={14} />
      </span>
    </span>
  );
}
