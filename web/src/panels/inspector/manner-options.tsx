import { setTransition, type TransitionOptions } from "../../document/commands/transitions";
import type { Choice, Segment } from "../../document/scene";
import { Row } from "../controls/row";
import { Select } from "../controls/select";
import { Switch } from "../controls/switch";
import { useStudio } from "../studio";
import { HierarchyRows } from "./hierarchy-rows";
import { optionsShown } from "./options-shown";
import { TIMINGS, timingNote } from "./words";

/** In what manner the method is gone through: when fast, in what size, by which groups. */
export function MannerOptions(props: { index: number; segment: Segment; choice: Choice | null }) {
  const { document } = useStudio();
  const { index, segment, choice } = props;
  const change = (options: TransitionOptions) => document.perform(setTransition(index, options));
  return (
    <>
      <Row label="Timing" note={timingNote(segment.timing)}>
        <Select label="Timing" value={segment.timing} choices={TIMINGS} onChoose={(timing) => change({ timing })} />
      </Row>
      {optionsShown(segment, choice).hasKeepSize && (
        <Switch
          label="Keep the size"
          note="it does not shrink on the way"
          isOn={segment.keepSize}
          onToggle={(keepSize) => change({ keepSize })}
        />
      )}
      <HierarchyRows index={index} segment={segment} choice={choice} />
    </>
  );
}
