import { setMinimumDistance } from "../../document/commands/scene";
import { metersPer } from "../../document/units";
import { QuantityRow } from "../controls/quantity-row";
import { useStudio } from "../studio";
import { lengthQuantity } from "./quantities";

/** Meters that the slider reaches at least; a scene may ask for more. */
const USUAL_MOST = 3;

/** How near two agents may come. One number for the whole scene, wherever it is set. */
export function MinimumDistanceRow() {
  const { document } = useStudio();
  const { minimumDistance, stage } = document.scene.value;
  const per = metersPer(stage.units);
  const most = Math.ceil(Math.max(USUAL_MOST, minimumDistance) / per);
  return (
    <QuantityRow
      label="Minimum distance"
      shortLabel="Min. distance"
      note="whole scene"
      value={minimumDistance / per}
      quantity={lengthQuantity(stage.units, { min: 0, max: most, step: 0.05 })}
      command={(value) => setMinimumDistance(Number((value * per).toFixed(6)))}
    />
  );
}
