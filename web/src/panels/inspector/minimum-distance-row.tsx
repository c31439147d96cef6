import { setMinimumDistance } from "../../document/commands/scene";
import { mainTrack, type Scene } from "../../document/scene";
import { mostApart, widestApart } from "../../document/spread";
import { lengthWithUnit, metersPer } from "../../document/units";
import { QuantityRow } from "../controls/quantity-row";
import { useStudio } from "../studio";
import { lengthQuantity } from "./quantities";

/** Meters that the slider reaches at least; a scene may ask for more. */
const USUAL_MOST = 3;

/** How near two agents may come. One number for the whole scene, wherever it is set. */
export function MinimumDistanceRow() {
  const { document } = useStudio();
  const scene = document.scene.value;
  const { minimumDistance, stage } = scene;
  const per = metersPer(stage.units);
  const most = Math.ceil(Math.max(USUAL_MOST, minimumDistance) / per);
  const tooMuch = crowding(scene);
  return (
    <>
      <QuantityRow
        label="Minimum distance"
        shortLabel="Min. distance"
        note="whole scene"
        value={minimumDistance / per}
        quantity={lengthQuantity(stage.units, { min: 0, max: most, step: 0.05 })}
        command={(value) => setMinimumDistance(Number((value * per).toFixed(6)))}
      />
      {tooMuch && <p class="inspector-text row-text">{tooMuch}</p>}
    </>
  );
}

/** What the stage cannot hold, for whoever stays on it, and what it can. */
function crowding(scene: Scene): string | null {
  const { minimumDistance, stage } = scene;
  const { agents, keyframes } = mainTrack(scene);
  const most = mostApart(stage.width, stage.depth, minimumDistance);
  // Whoever is above another needs no place beside them.
  if (agents.length <= most || keyframes.some(({ positions }) => positions.heights)) return null;
  const fitting = lengthWithUnit(widestApart(stage.width, stage.depth, agents.length), stage.units);
  return `The stage holds at most ${most} agents this far apart, and there are ${agents.length}; ${fitting} fits, or a larger stage.`;
}
