import { secondsPerCount } from "../../document/counts";
import { NumberBox } from "../controls/number-box";
import { Row } from "../controls/row";
import { useStudio } from "../studio";
import { countsQuantity, spanQuantity } from "./quantities";

/** How long something lasts, in seconds or, where the timeline reads them, in counts; either can be typed. */
export function SpanRow(props: {
  label: string;
  /** Seconds, as everything below. */
  value: number;
  min: number;
  max: number;
  onCommit(seconds: number): void;
}) {
  const { document, view } = useStudio();
  const { tempo } = document.scene.value;
  const { label, value, min, max } = props;
  if (view.ruler.value === "seconds") {
    return (
      <Row label={label}>
        <NumberBox
          label={label}
          value={value}
          quantity={spanQuantity(tempo, { min, max })}
          onCommit={(seconds) => props.onCommit(seconds)}
        />
      </Row>
    );
  }
  return (
    <Row label={label} note="counts">
      <NumberBox
        label={label}
        value={value / secondsPerCount(tempo)}
        quantity={countsQuantity(tempo, { min, max })}
        isUnitBeside
        onCommit={(counts) => props.onCommit(counts * secondsPerCount(tempo))}
      />
    </Row>
  );
}
