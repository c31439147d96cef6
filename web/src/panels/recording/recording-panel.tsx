import "./recording.css";
import { useSignalEffect } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { formatCount, formatDuration } from "../../document/units";
import { Switch } from "../controls/switch";
import { Section } from "../inspector/section";
import { SidePanel } from "../side-panel";
import { useStudio } from "../studio";
import { PickList } from "./pick-list";
import { whyNot, withPick } from "./picks";
import { lookAt, makeScene } from "./recording-acts";
import { Scrubber } from "./scrubber";
import { isOriginalShown, isWalked, type OpenRecording, opened, recorded, setPicks } from "./state";

/** A recording: walk through it, pick frames, and make a scene of them. */
export function RecordingPanel() {
  const now = opened.value;
  const isMade = now !== null && now.made !== null;
  return (
    <SidePanel
      name="Recording"
      leaves={isMade && isOriginalShown.value ? { kind: "original" } : null}
      title={<span class="ellipsis">{now?.name ?? "Nothing is open"}</span>}
    >
      {now ? <Course open={now} /> : <Nothing />}
    </SidePanel>
  );
}

function Nothing() {
  const { actions } = useStudio();
  return (
    <Section>
      <p class="inspector-text">
        Open a motion as CSV, or a text file of JuPedSim, and pick frames of it as keyframes of a new scene.
      </p>
      <button type="button" class="button" onClick={() => actions.get("open").run()}>
        Choose a file
      </button>
    </Section>
  );
}

function Course({ open }: { open: OpenRecording }) {
  const studio = useStudio();
  const { recording, picks, made } = open;
  useEffect(() => {
    if (opened.peek()?.made === null) lookAt(studio, open);
    return () => {
      isWalked.value = false;
      studio.view.fit();
    };
  }, [recording]);
  useSignalEffect(() => {
    if (studio.playback.isPlaying.value) isWalked.value = false;
  });
  const problem = whyNot(recording, picks);
  return (
    <>
      <Section>
        <p class="inspector-text">
          {formatCount(recording.agentCount)} agents, {formatCount(recording.frameCount)} frames,{" "}
          {formatDuration(recording.duration)} at {Number(recording.frameRate.toFixed(2))} frames a second.
        </p>
        {recording.notes.map((note) => (
          <p key={note} class="inspector-text">
            {note}
          </p>
        ))}
        <Scrubber recording={recording} />
        <button
          type="button"
          class="button recording-pick"
          onClick={() => setPicks(withPick(picks, recording.frameAt(recorded.time.peek())))}
        >
          Pick this frame as keyframe
        </button>
      </Section>
      <Section title="Picked frames">
        <PickList open={open} />
        <button
          type="button"
          class="button"
          disabled={problem !== null}
          aria-describedby={problem === null ? undefined : "recording-why-not"}
          onClick={() => makeScene(studio, open)}
        >
          Make scene
        </button>
        {problem !== null && picks.length > 0 && (
          <p id="recording-why-not" class="inspector-text" role="status">
            {problem}
          </p>
        )}
      </Section>
      {made !== null && (
        <Section title="Beside the new motion">
          <Switch
            label="Show original"
            note="faint, in step with the new motion"
            isOn={isOriginalShown.value}
            onToggle={(isOn) => {
              isOriginalShown.value = isOn;
              isWalked.value = false;
            }}
          />
        </Section>
      )}
      <Section>
        <p class="inspector-text">
          The recording is remembered until this page closes; it is no part of the scene and not in its files or links.
        </p>
      </Section>
    </>
  );
}
