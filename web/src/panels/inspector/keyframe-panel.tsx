import { mayLieBetween } from "../../document/between";
import { renameKeyframe, setBetween, setCorner } from "../../document/commands/keyframes";
import { retimeKeyframe, setHold } from "../../document/commands/retime";
import { dropOwnTies } from "../../document/commands/ties";
import { barAndCount } from "../../document/counts";
import { updateKeyframe } from "../../document/edit";
import { LIMITS } from "../../document/limits";
import { keyframeLabel } from "../../document/queries";
import { mainTrack } from "../../document/scene";
import type { Command } from "../../document/store";
import { liesBetween } from "../../document/stretches";
import { WordAction } from "../action-button";
import { NumberBox } from "../controls/number-box";
import { Row } from "../controls/row";
import { Switch } from "../controls/switch";
import { lazily } from "../lazily";
import { useStudio } from "../studio";
import { BreachNote } from "./breach-note";
import { Head } from "./head";
import { NameRow } from "./name-row";
import { instantQuantity } from "./quantities";
import { Section } from "./section";
import { SpanRow } from "./span-row";

const AbsenceNote = lazily(() => import("../absence/absence-note").then((part) => part.AbsenceNote));

/** One formation of the show: when it is reached, how long it stands, who belongs together in it. */
export function KeyframePanel({ index }: { index: number }) {
  const { document, view } = useStudio();
  const scene = document.scene.value;
  const track = mainTrack(scene);
  const { keyframes } = track;
  const keyframe = keyframes[index];
  if (!keyframe) return null;
  return (
    <>
      <Head kind="Keyframe" aside={<span class="number">{`${index + 1} of ${keyframes.length}`}</span>}>
        <span class="ellipsis">{keyframeLabel(scene, index)}</span>
      </Head>
      <Section>
        <NameRow
          key={index}
          name={keyframe.name}
          label={keyframeLabel(scene, index)}
          onCommit={(name) => document.perform(renameKeyframe(index, name))}
        />
        <Row label="At" {...(view.ruler.value === "counts" ? { note: barAndCount(scene.tempo, keyframe.time) } : {})}>
          <NumberBox
            label="Keyframe time"
            value={keyframe.time}
            quantity={instantQuantity(scene.tempo)}
            onCommit={(time) => document.perform(retimeKeyframe(index, time))}
          />
        </Row>
        <SpanRow
          label="Hold"
          value={keyframe.hold}
          min={0}
          max={LIMITS.seconds}
          onCommit={(hold) => document.perform(setHold(index, hold))}
        />
        {scene.join !== "separate" && (
          <Switch
            label="Corner"
            note="a stop on the way"
            isOn={keyframe.corner}
            onToggle={(isOn) => document.perform(setCorner(index, isOn))}
          />
        )}
        {mayLieBetween(track, index) && (
          <Switch
            label="In-between"
            note="bends its transition, ends none"
            isOn={liesBetween(track, index)}
            onToggle={(isOn) => document.perform(setBetween(index, isOn))}
          />
        )}
        {/* Who belongs together is asked at the ends of transitions. */}
        {!liesBetween(track, index) && (
          <Switch
            label="Ties of its own"
            note="else those of the whole scene"
            isOn={keyframe.adjacency !== null}
            onToggle={(isOn) => document.perform(isOn ? giveOwnTies(index) : dropOwnTies(index))}
          />
        )}
        {keyframe.absent.length > 0 && <AbsenceNote index={index} />}
        <BreachNote index={index} />
        <div class="inspector-buttons">
          <WordAction id="modes" class="button">
            Modes
          </WordAction>
        </div>
      </Section>
    </>
  );
}

/** A keyframe's own ties start as those of the scene. */
function giveOwnTies(index: number): Command {
  return {
    label: "Give the keyframe its own ties",
    apply: (scene) =>
      updateKeyframe(scene, index, (was) => (was.adjacency ? was : { ...was, adjacency: scene.adjacency })),
  };
}
