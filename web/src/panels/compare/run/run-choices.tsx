import type { ComponentChildren } from "preact";
import { LIMITS } from "../../../document/limits";
import type { Units } from "../../../document/scene";
import { metersPer } from "../../../document/units";
import { NumberBox } from "../../controls/number-box";
import { Row } from "../../controls/row";
import { Select } from "../../controls/select";
import { Switch } from "../../controls/switch";
import { lengthQuantity } from "../../inspector/quantities";
import { COSTS, RUN_PRESETS, type RunChoice, WAYS } from "./run-words";

const OWN_CHOICE = "own";

/** What a person may ask a run for, beside which ways and costs. */
export interface RunSetting extends RunChoice {
  /** Meters a second. */
  readonly pace: number;
  readonly isAvoiding: boolean;
}

/** Which ways under which costs, and when everybody is to arrive. */
export function RunChoices(props: {
  setting: RunSetting;
  units: Units;
  onChange(change: Partial<RunSetting>): void;
  children: ComponentChildren;
}) {
  const { setting, units, onChange } = props;
  const preset = RUN_PRESETS.find((candidate) => isChosen(setting, candidate))?.id ?? OWN_CHOICE;
  return (
    <div class="run-choices">
      <Select
        label="What to compare"
        value={preset}
        choices={[
          { value: OWN_CHOICE, label: "Ways of your own" },
          ...RUN_PRESETS.map(({ id, label }) => ({ value: id, label })),
        ]}
        onChoose={(id) => {
          const chosen = RUN_PRESETS.find((candidate) => candidate.id === id);
          if (chosen) onChange({ ways: chosen.ways, costs: chosen.costs, isFree: chosen.isFree });
        }}
      />
      <Checks
        legend="Methods"
        all={WAYS.map(({ way, label }) => ({ value: way, label }))}
        chosen={setting.ways}
        onChange={(ways) => onChange({ ways })}
      />
      <Checks
        legend="Who goes where"
        all={COSTS.map(({ cost, label }) => ({ value: cost, label }))}
        chosen={setting.costs}
        onChange={(costs) => onChange({ costs })}
      />
      <Switch
        label="Free arrival"
        note="everybody at one pace"
        isOn={setting.isFree}
        onToggle={(isFree) => onChange({ isFree })}
      />
      {setting.isFree && (
        <Row label="Pace">
          <NumberBox
            label="Pace"
            value={setting.pace / metersPer(units)}
            quantity={paceQuantity(units)}
            onCommit={(pace) => onChange({ pace: pace * metersPer(units) })}
          />
        </Row>
      )}
      <Switch label="Avoid collisions" isOn={setting.isAvoiding} onToggle={(isAvoiding) => onChange({ isAvoiding })} />
      {props.children}
    </div>
  );
}

function paceQuantity(units: Units) {
  const { min, max } = LIMITS.maxSpeed;
  const per = metersPer(units);
  return { ...lengthQuantity(units, { min: min / per, max: max / per, step: 0.1 }), unit: `${units}/s` };
}

function isChosen(setting: RunChoice, preset: RunChoice): boolean {
  const isSame = (a: readonly string[], b: readonly string[]) => [...a].sort().join() === [...b].sort().join();
  return setting.isFree === preset.isFree && isSame(setting.ways, preset.ways) && isSame(setting.costs, preset.costs);
}

/** Any of several; in the order of the list, whatever was ticked first. */
function Checks<T extends string>(props: {
  legend: string;
  all: readonly { readonly value: T; readonly label: string }[];
  chosen: readonly T[];
  onChange(chosen: readonly T[]): void;
}) {
  const { all, chosen, onChange } = props;
  const toggled = (value: T) =>
    all.map((one) => one.value).filter((one) => (one === value ? !chosen.includes(one) : chosen.includes(one)));
  return (
    <fieldset class="run-checks">
      <legend>{props.legend}</legend>
      {all.map(({ value, label }) => (
        <label key={value}>
          <input type="checkbox" checked={chosen.includes(value)} onChange={() => onChange(toggled(value))} />
          {label}
        </label>
      ))}
    </fieldset>
  );
}
