import { useComputed } from "@preact/signals";
import { Maximize, Minus, Plus } from "lucide";
import { Icon } from "../../theme/icons";
import { useStudio } from "../studio";

/** Two presses double. */
const STEP = Math.SQRT2;

/** How close the stage is seen; 100 % is all of it. */
export function ZoomPill() {
  const { view } = useStudio();
  const percent = useComputed(() => `${Math.round(view.zoom.value * 100)} %`);
  return (
    <fieldset class="floating zoom-pill" aria-label="Zoom">
      <button type="button" class="icon-button" aria-label="Zoom out" onClick={() => view.zoomBy(1 / STEP)}>
        <Icon node={Minus} size={14} />
      </button>
      <output class="zoom-value number">{percent}</output>
      <button type="button" class="icon-button" aria-label="Zoom in" onClick={() => view.zoomBy(STEP)}>
        <Icon node={Plus} size={14} />
      </button>
      <button
        type="button"
        class="icon-button"
        aria-label="Fit"
        data-tip="Fit"
        data-tip-side="top"
        onClick={() => view.fit()}
      >
        <Icon node={Maximize} size={14} />
      </button>
    </fieldset>
  );
}
