import { AGENT_COLORS } from "../../document/palette";

const NAMES = ["Vermilion", "Cobalt", "Amber", "Pine", "Rose", "Sky", "Plum", "Green", "Olive", "Ink"] as const;

/** The palette to choose from. Pressing the chosen color gives it back for the one that follows from the group. */
export function ColorRow(props: {
  label: string;
  /** As stored; empty when it follows. */
  color: string;
  /** The stored color that shows, one's own or not; null when several differ. */
  shown: string | null;
  onChoose(color: string): void;
}) {
  return (
    <fieldset class="swatches" aria-label={props.label}>
      {AGENT_COLORS.map((color, index) => (
        <button
          key={color}
          type="button"
          class={`swatch agent-${index + 1}`}
          aria-label={NAMES[index]}
          aria-pressed={color === props.shown?.toLowerCase()}
          title={NAMES[index]}
          onClick={() => props.onChoose(color === props.color.toLowerCase() ? "" : color)}
        />
      ))}
    </fieldset>
  );
}
