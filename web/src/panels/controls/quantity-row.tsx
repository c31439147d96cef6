import type { Command } from "../../document/store";
import { NumberBox } from "./number-box";
import type { Quantity } from "./quantity";
import { Row } from "./row";
import { Slider } from "./slider";
import { useGesture } from "./use-gesture";

/** A slider and a number box for one quantity of the scene; a drag is one undo entry. */
export function QuantityRow(props: {
  label: string;
  /** What the row reads when the full name does not fit. */
  shortLabel?: string;
  note?: string;
  value: number;
  quantity: Quantity;
  tick?: number;
  /** What the least and the most of it are like, under the ends of the slider. */
  ends?: readonly [least: string, most: string];
  /** The command that sets the quantity. */
  command(value: number): Command;
}) {
  const gesture = useGesture();
  return (
    <Row label={props.shortLabel ?? props.label} {...(props.note ? { note: props.note } : {})}>
      <span class={props.quantity.unit.length > 3 ? "quantity wide" : "quantity"}>
        <Slider
          label={props.label}
          value={props.value}
          quantity={props.quantity}
          {...(props.tick === undefined ? {} : { tick: props.tick })}
          onPreview={(value) => gesture.preview(props.command(value))}
          onCommit={gesture.commit}
          onCancel={gesture.cancel}
        />
        <NumberBox
          label={props.label}
          value={props.value}
          quantity={props.quantity}
          onCommit={(value) => gesture.perform(props.command(value))}
        />
        {props.ends && (
          <span class="slider-ends" aria-hidden="true">
            <span>{props.ends[0]}</span>
            <span>{props.ends[1]}</span>
          </span>
        )}
      </span>
    </Row>
  );
}
