import { setTransition } from "../../document/commands/transitions";
import { type Choice, mainTrack, type Segment } from "../../document/scene";
import { WordAction } from "../action-button";
import { QuantityRow } from "../controls/quantity-row";
import { Row } from "../controls/row";
import { Select } from "../controls/select";
import { Switch } from "../controls/switch";
import { useStudio } from "../studio";
import { HierarchyRows } from "./hierarchy-rows";
import { MinimumDistanceRow } from "./minimum-distance-row";
import { optionsShown, takenOver } from "./options-shown";
import { SHARING } from "./quantities";
import { ALIGNMENTS, METHODS, methodWord, ORDERS, TIMINGS } from "./words";

/** The method and what it can be told. Under auto the options read what auto took; changing one takes over from it. */
export function TransitionOptions(props: { index: number; segment: Segment; choice: Choice | null }) {
  const { document } = useStudio();
  const { index, segment, choice } = props;
  const shown = optionsShown(segment, choice);
  const isAuto = segment.method === "auto";
  const by = (isUsed: boolean) => (isAuto && isUsed ? "by auto" : undefined);

  return (
    <>
      <Row label="Method">
        <Select
          label="Method"
          value={segment.method}
          choices={METHODS}
          detail={isAuto && choice ? `chose ${methodWord(choice.method)}` : undefined}
          onChoose={(method) => document.perform(setTransition(index, { method }))}
        />
      </Row>
      {shown.hasOrder && (
        <Row label="Order">
          <Select
            label="Order"
            value={shown.order}
            choices={ORDERS}
            detail={by(choice?.method === "spectral")}
            onChoose={(order) => document.perform(setTransition(index, takenOver(segment, choice, { order })))}
          />
        </Row>
      )}
      {shown.hasAlignment && (
        <Row label="Alignment">
          <Select
            label="Alignment"
            value={shown.alignment}
            choices={ALIGNMENTS}
            detail={by(choice !== null && choice.method !== "linear")}
            onChoose={(alignment) => document.perform(setTransition(index, takenOver(segment, choice, { alignment })))}
          />
        </Row>
      )}
      {shown.hasSharing && (
        <QuantityRow
          label="Sharing"
          value={shown.sharing}
          quantity={SHARING}
          command={(sharing) => setTransition(index, takenOver(segment, choice, { sharing }))}
        />
      )}
      <Switch
        label="Avoid collisions"
        isOn={segment.avoidance}
        onToggle={(avoidance) => document.perform(setTransition(index, { avoidance }))}
      />
      <MinimumDistanceRow />
      <Row label="Timing">
        <Select
          label="Timing"
          value={segment.timing}
          choices={TIMINGS}
          onChoose={(timing) => document.perform(setTransition(index, { timing }))}
        />
      </Row>
      {shown.hasKeepSize && (
        <Switch
          label="Keep the size"
          isOn={segment.keepSize}
          onToggle={(keepSize) => document.perform(setTransition(index, { keepSize }))}
        />
      )}
      <HierarchyRows index={index} segment={segment} choice={choice} />
      {mainTrack(document.scene.value).segments.length > 1 && (
        <WordAction id="use-everywhere" class="button quiet use-everywhere">
          Use for every transition
        </WordAction>
      )}
    </>
  );
}
