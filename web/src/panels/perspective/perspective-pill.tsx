import { Armchair, Maximize, Minus, Plus } from "lucide";
import type { BodyKind } from "../../stage/perspective/bodies";
import { Icon } from "../../theme/icons";
import { IconAction } from "../action-button";
import { type Choice, Select } from "../controls/select";

const BODIES: readonly Choice<BodyKind>[] = [
  { value: "figures", label: "Figures" },
  { value: "cones", label: "Cones" },
  { value: "discs", label: "Discs" },
];

/** What agents look like, and where they are seen from. */
export function PerspectivePill(props: { bodies: BodyKind; onBodies(kind: BodyKind): void; sitDown(): void }) {
  return (
    <fieldset class="floating perspective-pill" aria-label="Perspective view">
      <Select label="Show agents as" value={props.bodies} choices={BODIES} onChoose={props.onBodies} />
      <button type="button" class="button quiet" onClick={props.sitDown}>
        <Icon node={Armchair} size={14} /> Audience's seat
      </button>
      <span class="separator" />
      <IconAction id="zoom-out" icon={Minus} size={14} side="top" />
      <IconAction id="zoom-in" icon={Plus} size={14} side="top" />
      <IconAction id="fit" name="Reset view" icon={Maximize} size={14} side="top" />
    </fieldset>
  );
}
