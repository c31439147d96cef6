import type { ComponentChildren } from "preact";

/** A measure: its name, its course, its mean and its worst. */
export function Measure(props: {
  label: string;
  plot: ComponentChildren;
  value: string;
  unit?: string;
  worst: string;
}) {
  return (
    <dl class="measure">
      <dt>{props.label}</dt>
      <dd class="measure-plot">{props.plot}</dd>
      <dd class="measure-value number">
        {props.value} {props.unit && <span class="unit">{props.unit}</span>}
        <small>{props.worst}</small>
      </dd>
    </dl>
  );
}
