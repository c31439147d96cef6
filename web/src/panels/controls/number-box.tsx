import { useEffect, useRef, useState } from "preact/hooks";
import { useStudio } from "../studio";
import { Correction } from "./correction";
import { undidScene } from "./field-undo";
import { asNear, clampTo, type Quantity, rangeWords, stepped, stepsOf, withUnit } from "./quantity";

/** How long it is said that a number was corrected, milliseconds. */
const CORRECTION_TIME = 6000;

/** Units are converted back and forth. */
const ROUND_OFF = 1e-6;

/**
 * A number to type, step with the arrows, and read with its unit. It is taken over on Enter and on leaving; Escape
 * leaves it as it was. What is no number keeps its edge in red and is not taken over; what is too small or too large,
 * for itself or beside what else is in the scene, becomes what is admissible, and that is said.
 */
export function NumberBox(props: {
  label: string;
  value: number;
  quantity: Quantity;
  /** A letter before the number, in a box without a row of its own. */
  prefix?: string;
  /** The unit is said beside the box, which has no room for it. */
  isUnitBeside?: boolean;
  isDisabled?: boolean;
  /** Taken over while it is typed: for settings, which are not undone. */
  isLive?: boolean;
  /** What is out of bounds is taken over as it is, and told: whoever asked judges it. */
  isUnbound?: boolean;
  describedBy?: string | undefined;
  onCommit(value: number): void;
}) {
  const { actions, messages } = useStudio();
  const { value, quantity } = props;
  const box = useRef<HTMLLabelElement>(null);
  const [draft, setDraft] = useState<string | null>(null);
  const [correction, setCorrection] = useState<string | null>(null);
  /** What was taken over just now: the scene may have made something else of it. */
  const [asked, setAsked] = useState<number | null>(null);
  useEffect(() => {
    if (correction === null) return;
    const timer = setTimeout(() => setCorrection(null), CORRECTION_TIME);
    return () => clearTimeout(timer);
  }, [correction]);
  const bound = (number: number) => (props.isUnbound ? number : clampTo(quantity, number));
  const typed = draft === null ? value : quantity.parse(draft);
  const isInvalid = typed === null || (props.isUnbound === true && typed !== clampTo(quantity, typed));

  function tell(words: string): void {
    setCorrection(words);
    messages.announce(`${props.label}: ${words}`);
  }
  useEffect(() => {
    if (asked === null) return;
    setAsked(null);
    const isOther = Math.abs(asked - value) > ROUND_OFF && quantity.format(asked) !== quantity.format(value);
    if (isOther) tell(asNear(withUnit(quantity, value)));
  }, [asked]);

  /** Takes a number over, and says when it is not what was asked for. */
  function take(number: number): void {
    const admissible = clampTo(quantity, number);
    if (admissible !== number) tell(rangeWords(quantity));
    else if (!props.isLive) setAsked(number);
    props.onCommit(bound(number));
  }

  function commit(): void {
    const typed = draft === null ? null : quantity.parse(draft);
    setDraft(null);
    if (typed !== null && (props.isLive || draft !== quantity.format(value))) take(typed);
  }

  return (
    <label
      ref={box}
      class="number-box"
      data-invalid={isInvalid ? "" : undefined}
      data-disabled={props.isDisabled ? "" : undefined}
    >
      {props.prefix && <span class="unit">{props.prefix}</span>}
      <input
        role="spinbutton"
        inputMode="decimal"
        autocomplete="off"
        spellcheck={false}
        aria-label={props.label}
        aria-valuenow={value}
        aria-valuemin={quantity.min}
        aria-valuemax={quantity.max}
        aria-valuetext={`${quantity.format(value)} ${quantity.unit}`.trim()}
        aria-invalid={isInvalid}
        aria-describedby={props.describedBy}
        disabled={props.isDisabled ?? false}
        value={draft ?? quantity.format(value)}
        onFocus={(event) => event.currentTarget.select()}
        onInput={(event) => {
          const typed = quantity.parse(event.currentTarget.value);
          setDraft(event.currentTarget.value);
          setCorrection(null);
          if (props.isLive && typed !== null) props.onCommit(bound(typed));
        }}
        onBlur={commit}
        onKeyDown={(event) => {
          if (draft === null && undidScene(event, actions)) return;
          if (event.key === "Enter") commit();
          if (event.key === "Escape") setDraft(null);
          const steps =
            event.key.startsWith("Arrow") && event.key !== "ArrowUp" && event.key !== "ArrowDown"
              ? null
              : stepsOf(event);
          if (steps === null) return;
          event.preventDefault();
          const from = (draft === null ? null : quantity.parse(draft)) ?? value;
          setDraft(null);
          const next = stepped(quantity, from, steps);
          if (next === from) tell(rangeWords(quantity));
          else take(next);
        }}
      />
      {quantity.unit && !props.isUnitBeside && <span class="unit">{quantity.unit}</span>}
      {correction !== null && <Correction words={correction} anchor={box.current} />}
    </label>
  );
}
