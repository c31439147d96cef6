import type { Signal } from "@preact/signals";
import { useStudio } from "../studio";
import { keyName, keyShortcuts } from "../use-action";
import { InfoLine } from "./info-line";
import { LayerToggles } from "./layer-toggles";
import { SheetButton } from "./sheet-button";
import { ZoomPill } from "./zoom-pill";

/** From where and how close the stage is seen, what shows on it and what its marks mean, and the way to the inspector. */
export function ViewPills({ isSheetOpen }: { isSheetOpen: Signal<boolean> }) {
  return (
    <>
      <div class="floating view-pills">
        <ProjectionSwitch />
        <span class="separator" />
        <LayerToggles />
      </div>
      <InfoLine />
      <ZoomPill />
      <SheetButton isOpen={isSheetOpen} />
    </>
  );
}

const PROJECTIONS = [
  { projection: "plan", name: "Plan" },
  { projection: "front", name: "Front" },
  { projection: "perspective", name: "Perspective" },
] as const;

/** The plan, the stage from the front, or the show in perspective. */
export function ProjectionSwitch() {
  const { view, actions } = useStudio();
  return (
    <fieldset class="layer-toggles" aria-label="Seen as">
      {PROJECTIONS.map(({ projection, name }) => {
        const action = actions.get(projection === "front" ? "front" : "perspective");
        const [key] = action.keys;
        return (
          <button
            key={projection}
            type="button"
            class="toggle"
            aria-pressed={view.projection.value === projection}
            aria-keyshortcuts={keyShortcuts(action.keys)}
            title={key && `${action.label} (${keyName(key)})`}
            onClick={() => {
              view.projection.value = projection;
            }}
          >
            {name}
          </button>
        );
      })}
    </fieldset>
  );
}
