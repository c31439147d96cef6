import { useRef } from "preact/hooks";
import { clampTo, fractionOf, type Quantity, stepped, stepsOf, valueAt } from "./quantity";

/** Half the width of the thumb, CSS pixels: its middle reaches the ends of the track less this. */
const THUMB = 8;

/**
 * A range from faint to firm. Its value is the quantity itself, also on a logarithmic scale, so that scripts and
 * screen readers meet the number a person reads; the pointer is followed here because a range is linear by nature.
 */
export function Slider(props: {
  label: string;
  value: number;
  quantity: Quantity;
  /** A value worth finding again: a tick on the track. */
  tick?: number;
  isDisabled?: boolean;
  onPreview(value: number): void;
  onCommit(): void;
  onCancel(): void;
}) {
  const { quantity } = props;
  const dragging = useRef<number | null>(null);
  const value = clampTo(quantity, props.value);

  function follow(event: PointerEvent & { readonly currentTarget: HTMLInputElement }): void {
    const box = event.currentTarget.getBoundingClientRect();
    props.onPreview(valueAt(quantity, (event.clientX - box.left - THUMB) / (box.width - 2 * THUMB)));
  }

  return (
    <span class="slider" style={{ "--at": fractionOf(quantity, value) }}>
      <input
        type="range"
        aria-label={props.label}
        aria-valuetext={`${quantity.format(props.value)} ${quantity.unit}`.trim()}
        min={quantity.min}
        max={quantity.max}
        step="any"
        value={value}
        disabled={props.isDisabled ?? false}
        onInput={(event) => props.onPreview(clampTo(quantity, event.currentTarget.valueAsNumber))}
        onChange={props.onCommit}
        onPointerDown={(event) => {
          if (event.button !== 0 || props.isDisabled) return;
          event.preventDefault();
          event.currentTarget.focus({ focusVisible: false } as FocusOptions);
          event.currentTarget.setPointerCapture(event.pointerId);
          dragging.current = event.pointerId;
          follow(event);
        }}
        onPointerMove={(event) => {
          if (dragging.current === event.pointerId) follow(event);
        }}
        onPointerUp={() => {
          if (dragging.current !== null) props.onCommit();
          dragging.current = null;
        }}
        onPointerCancel={() => {
          if (dragging.current !== null) props.onCancel();
          dragging.current = null;
        }}
        onKeyDown={(event) => {
          if (event.key === "Escape" && dragging.current !== null) {
            dragging.current = null;
            event.stopPropagation();
            props.onCancel();
          }
          const steps = stepsOf(event);
          if (steps === null || event.altKey || event.ctrlKey || event.metaKey) return;
          event.preventDefault();
          event.stopPropagation();
          props.onPreview(stepped(quantity, props.value, steps));
          props.onCommit();
        }}
      />
      <span class="slider-track" />
      <span class="slider-ribbon" />
      {props.tick !== undefined && <span class="slider-tick" style={{ "--tick": fractionOf(quantity, props.tick) }} />}
      <span class="slider-thumb" />
    </span>
  );
}
