import "./more-rows.css";
import { setTransition } from "../../document/commands/transitions";
import { CROWD_DEFAULTS } from "../../document/generated";
import { parseNumber } from "../../document/parse";
import type { CrowdSpec, Segment } from "../../document/scene";
import type { Quantity } from "../controls/quantity";
import { QuantityRow } from "../controls/quantity-row";
import { Row } from "../controls/row";
import { Select } from "../controls/select";
import { Switch } from "../controls/switch";
import { useStudio } from "../studio";
import { PLAIN_METHODS } from "./words";

type Constant = { [K in keyof CrowdSpec]: CrowdSpec[K] extends number ? K : never }[keyof CrowdSpec];

interface ConstantRow {
  readonly name: Constant;
  readonly label: string;
  /** The symbol of the paper, and what the number is. */
  readonly note: string;
  readonly quantity: Quantity;
}

function quantity(max: number, step: number, unit = "", min = 0): Quantity {
  const format = (value: number) => String(Number(value.toFixed(2)));
  return { min, max, step, scale: "linear", unit, format, parse: parseNumber };
}

/** Lengths are in spacings of the formations, so that a crowd moves alike at any scale. */
const CONSTANTS: readonly ConstantRow[] = [
  { name: "strength", label: "Repulsion", note: "A, keeps apart", quantity: quantity(20, 0.5) },
  { name: "reach", label: "Reach", note: "B, in spacings", quantity: quantity(2, 0.05, "", 0.05) },
  { name: "groupStrength", label: "Groups", note: "A′, draw together", quantity: quantity(5, 0.1) },
  { name: "groupReach", label: "Group reach", note: "B′, in spacings", quantity: quantity(10, 0.5, "", 0.5) },
  { name: "reactionTime", label: "Reaction", note: "τ, to a new velocity", quantity: quantity(3, 0.05, "s", 0.05) },
  { name: "lookAhead", label: "Looks ahead", note: "on the guide", quantity: quantity(3, 0.05, "s", 0.05) },
  { name: "fluctuation", label: "Fluctuation", note: "ξ, at random", quantity: quantity(5, 0.1) },
  { name: "binSize", label: "Bins", note: "R, in spacings", quantity: quantity(20, 0.5, "", 0.5) },
  { name: "sectors", label: "Sectors", note: "K, of a full turn", quantity: quantity(64, 1, "", 1) },
];

/** What a crowd follows, what its agents tell each other, and the table of its forces. */
export function CrowdRows({ index, segment }: { index: number; segment: Segment }) {
  const { document } = useStudio();
  const { crowd } = segment;
  const told = (change: Partial<CrowdSpec>) => setTransition(index, { crowd: { ...crowd, ...change } });
  const tell = (change: Partial<CrowdSpec>) => document.perform(told(change));
  const isChanged = CONSTANTS.some(({ name }) => crowd[name] !== CROWD_DEFAULTS[name]);
  return (
    <>
      <Row label="Guide" note="the way they follow">
        <Select label="Guide" value={crowd.guide} choices={PLAIN_METHODS} onChoose={(guide) => tell({ guide })} />
      </Row>
      <Switch
        label="Share direction"
        note="I_d, with neighbors"
        isOn={crowd.directionFeedback}
        onToggle={(directionFeedback) => tell({ directionFeedback })}
      />
      <Switch
        label="Share speed"
        note="I_v, with neighbors"
        isOn={crowd.speedFeedback}
        onToggle={(speedFeedback) => tell({ speedFeedback })}
      />
      <details class="more-rows">
        <summary>Forces</summary>
        {CONSTANTS.map(({ name, label, note, quantity: range }) => (
          <QuantityRow
            key={name}
            label={label}
            note={note}
            value={crowd[name]}
            quantity={range}
            command={(value) => told({ [name]: value })}
          />
        ))}
        <button
          type="button"
          class="button quiet"
          disabled={!isChanged}
          onClick={() => tell(Object.fromEntries(CONSTANTS.map(({ name }) => [name, CROWD_DEFAULTS[name]])))}
        >
          As they were
        </button>
      </details>
    </>
  );
}
