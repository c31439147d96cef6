import { keyframeLabel } from "../../document/queries";
import { mainTrack } from "../../document/scene";
import { useStudio } from "../studio";
import { keyframePlaces, transitionPlaces } from "./layout";
import { Ribbon } from "./ribbon-button";
import { transitionState } from "./transition-state";
import type { Viewport } from "./viewport";

/** The transitions between the keyframes, as ribbons. */
export function Ribbons({ viewport }: { viewport: Viewport }) {
  const { document, planner } = useStudio();
  const scene = document.scene.value;
  const { keyframes } = mainTrack(scene);
  const places = transitionPlaces(keyframePlaces(keyframes, viewport.scale.value));
  const plans = planner.segments.value;
  const selection = document.selection.value;
  return (
    <>
      <RibbonPaints />
      <ul class="ribbons" aria-label="Transitions">
        {places.map((place, index) => (
          <Ribbon
            key={index}
            index={index}
            names={`${keyframeLabel(scene, index)} to ${keyframeLabel(scene, index + 1)}`}
            place={place}
            state={transitionState(plans[index], scene.minimumDistance)}
            isSelected={selection.kind === "transition" && selection.index === index}
            viewport={viewport}
          />
        ))}
      </ul>
    </>
  );
}

/** From faint to firm, once a color; the ribbons refer to them. */
function RibbonPaints() {
  return (
    <svg class="ribbon-paints" width="0" height="0" aria-hidden="true">
      <defs>
        {(["holds", "tight", "clash", "none"] as const).map((status) =>
          (["quiet", "chosen"] as const).map((strength) => (
            <linearGradient
              key={strength}
              id={`ribbon-${status}-${strength}`}
              class={`paint is-${status} is-${strength}`}
            >
              <stop offset="0" class="faint" />
              <stop offset="1" class="firm" />
            </linearGradient>
          )),
        )}
      </defs>
    </svg>
  );
}
