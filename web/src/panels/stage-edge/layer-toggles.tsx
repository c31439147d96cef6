import type { Layers } from "../../stage/view";
import { useStudio } from "../studio";

const LAYERS: readonly { readonly layer: keyof Layers; readonly name: string }[] = [
  { layer: "ties", name: "Ties" },
  { layer: "trails", name: "Trails" },
  { layer: "ghosts", name: "Ghosts" },
  { layer: "groups", name: "Groups" },
  { layer: "names", name: "Names" },
];

/** What is to be seen in perspective, too. */
const IN_SPACE: ReadonlySet<keyof Layers> = new Set(["ties", "trails", "groups"]);

/** What the stage shows beside the agents. */
export function LayerToggles() {
  const { actions, view } = useStudio();
  const layers = view.layers.value;
  const shown = view.projection.value !== "perspective" ? LAYERS : LAYERS.filter(({ layer }) => IN_SPACE.has(layer));
  return (
    <fieldset class="layer-toggles" aria-label="Shown on the stage">
      {shown.map(({ layer, name }) => (
        <button
          key={layer}
          type="button"
          class="toggle"
          aria-pressed={layers[layer]}
          onClick={() => actions.get(`show-${layer}`).run()}
        >
          {name}
        </button>
      ))}
    </fieldset>
  );
}
