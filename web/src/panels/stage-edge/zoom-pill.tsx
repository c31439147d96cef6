import { useComputed } from "@preact/signals";
import { Maximize, Minus, Plus } from "lucide";
import { IconAction } from "../action-button";
import { useStudio } from "../studio";

/** How close the stage is seen; 100 % is all of it. */
export function ZoomPill() {
  const { view } = useStudio();
  const percent = useComputed(() => `${Math.round(view.zoom.value * 100)} %`);
  return (
    <fieldset class="floating zoom-pill" aria-label="Zoom">
      <IconAction id="zoom-out" icon={Minus} size={14} side="top" />
      <output class="zoom-value number">{percent}</output>
      <IconAction id="zoom-in" icon={Plus} size={14} side="top" />
      <IconAction id="fit" icon={Maximize} size={14} side="top" />
    </fieldset>
  );
}
