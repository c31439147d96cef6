import type { Point } from "../../document/formation";
import type { Units } from "../../document/scene";
import { metersPer } from "../../document/units";
import { NumberBox } from "../controls/number-box";
import { coordinateQuantity, isLongUnit } from "./quantities";

/** A place on the stage by its two coordinates; `of` tells it from other places in the panel. */
export function PlaceBoxes(props: { of?: string; at: Point; units: Units; onCommit(to: Point): void }) {
  const per = metersPer(props.units);
  const [x, y] = props.at;
  const box = (axis: "x" | "y", value: number, put: (meters: number) => Point) => (
    <NumberBox
      label={props.of ? `${props.of}, ${axis}` : axis}
      prefix={axis}
      value={value / per}
      quantity={coordinateQuantity(props.units)}
      isUnitBeside={isLongUnit(props.units)}
      onCommit={(changed) => props.onCommit(put(changed * per))}
    />
  );
  return (
    <span class="pair">
      {box("x", x, (meters) => [meters, y])}
      {box("y", y, (meters) => [x, meters])}
    </span>
  );
}
