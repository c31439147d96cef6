import { LIMITS } from "../../document/limits";
import type { Units } from "../../document/scene";
import { metersPer } from "../../document/units";
import { NumberBox } from "../controls/number-box";
import type { Quantity } from "../controls/quantity";
import { Row } from "../controls/row";
import { Segmented } from "../controls/segmented";
import { Slider } from "../controls/slider";
import { Switch } from "../controls/switch";
import { SHARING, sizeQuantity, wholeQuantity } from "../inspector/quantities";

/** How a shape is read and filled. */
export interface ReadingOptions {
  /** Brightness, 0..1: what is darker is the shape. */
  readonly threshold: number;
  readonly isInverted: boolean;
  readonly isOutline: boolean;
  readonly count: number;
  /** The longer side, meters; null: as large as the stage allows. */
  readonly size: number | null;
}

const THRESHOLD: Quantity = { ...SHARING, min: 0.01, max: 0.99, step: 0.01 };
const AGENTS = wholeQuantity(1, LIMITS.agents);

export function ReadingFields(props: {
  options: ReadingOptions;
  /** A picture has brightness to choose from; text and paths are what they are. */
  isPicture: boolean;
  /** Whether exactly the agents that there are stand there. */
  isCountGiven: boolean;
  /** What to know about the number of agents beforehand; null when there is nothing. */
  reason: string | null;
  /** The longer side as it is now, meters. */
  extent: number | null;
  units: Units;
  onChange(change: Partial<ReadingOptions>): void;
}) {
  const { options, onChange } = props;
  const per = metersPer(props.units);
  return (
    <>
      {props.isPicture && (
        <>
          <Row label="Threshold">
            <Slider
              label="Threshold"
              value={options.threshold}
              quantity={THRESHOLD}
              onPreview={(threshold) => onChange({ threshold })}
              onCommit={() => undefined}
              onCancel={() => undefined}
            />
          </Row>
          <Switch label="Invert" isOn={options.isInverted} onToggle={(isInverted) => onChange({ isInverted })} />
        </>
      )}
      <Row label="Agents stand">
        <Segmented<"fill" | "outline">
          label="Agents stand"
          value={options.isOutline ? "outline" : "fill"}
          choices={[
            { value: "fill", label: "Filled" },
            { value: "outline", label: "Outline" },
          ]}
          onChoose={(style) => onChange({ isOutline: style === "outline" })}
        />
      </Row>
      <Row label="Agents">
        <NumberBox
          label="Agents"
          value={options.count}
          quantity={AGENTS}
          isLive
          isDisabled={props.isCountGiven}
          describedBy={props.reason === null ? undefined : "shape-agents-reason"}
          onCommit={(count) => onChange({ count: Math.round(count) })}
        />
      </Row>
      {props.reason !== null && (
        <p class="tool-reason" id="shape-agents-reason">
          {props.reason}
        </p>
      )}
      <Row label="Longer side">
        <NumberBox
          label="Longer side"
          value={(options.size ?? props.extent ?? 0) / per}
          quantity={sizeQuantity(props.units)}
          isDisabled={options.size === null && props.extent === null}
          onCommit={(size) => onChange({ size: size * per })}
        />
      </Row>
    </>
  );
}
