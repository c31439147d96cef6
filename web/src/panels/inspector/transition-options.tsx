import { setTransition } from "../../document/commands/transitions";
import type { Choice, Segment } from "../../document/scene";
import { QuantityRow } from "../controls/quantity-row";
import { Row } from "../controls/row";
import { Switch } from "../controls/switch";
import { lazily } from "../lazily";
import { useStudio } from "../studio";
import { MinimumDistanceRow } from "./minimum-distance-row";
import { AlignmentSelect, MethodSelect, OrderSelect } from "./option-selects";
import { optionsShown, takenOver } from "./options-shown";
import { SHARING } from "./quantities";
import { alignmentNote, orderNote } from "./words";

const CrowdRows = lazily(() => import("./crowd-rows").then((part) => part.CrowdRows));

/** The method and what it can be told. Under auto the options read what auto took; changing one takes over from it. */
export function TransitionOptions(props: { index: number; segment: Segment; choice: Choice | null }) {
  const { document } = useStudio();
  const { index, segment, choice } = props;
  const shown = optionsShown(segment, choice);
  const option = {
    spec: segment,
    choice,
    onChange: (options: Parameters<typeof setTransition>[1]) => document.perform(setTransition(index, options)),
  };

  return (
    <>
      <Row label="Method">
        <MethodSelect {...option} />
      </Row>
      {segment.method === "crowd" && <CrowdRows index={index} segment={segment} />}
      {shown.hasOrder && (
        <Row label="Order" note={orderNote(shown.order)}>
          <OrderSelect {...option} />
        </Row>
      )}
      {shown.hasAlignment && (
        <Row label="Alignment" note={alignmentNote(shown.alignment)}>
          <AlignmentSelect {...option} />
        </Row>
      )}
      {shown.hasSharing && (
        <QuantityRow
          label="Sharing"
          ends={["turns fully", "turns least"]}
          value={shown.sharing}
          quantity={SHARING}
          command={(sharing) => setTransition(index, takenOver(segment, choice, { sharing }))}
        />
      )}
      <Switch
        label="Avoid collisions"
        isOn={segment.avoidance}
        onToggle={(avoidance) => option.onChange({ avoidance })}
      />
      <MinimumDistanceRow />
    </>
  );
}
