import "./modes.css";
import { useSignal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { useEffect, useMemo } from "preact/hooks";
import { presentAt } from "../../document/absence";
import { keyframeLabel } from "../../document/queries";
import { mainTrack } from "../../document/scene";
import { formatCount } from "../../document/units";
import { tieInputs } from "../../engine/inputs";
import { askModes } from "../../engine/modes";
import { Section } from "../inspector/section";
import { SidePanel } from "../side-panel";
import { useStudio } from "../studio";
import { useSolo } from "../use-solo";
import { useLatest } from "./latest";
import { FEW_MODES, modesToShow } from "./limits";
import { pairsAmong } from "./mode-geometry";
import { ModeSection } from "./mode-section";
import { picture } from "./picture";
import { TransitionSections } from "./transition-sections";

const NO_PAIRS = new Uint32Array(0);

/** What a formation is made of: its modes one after another, and how they become those of the next formation. */
export function ModesPanel() {
  const { document, planner, playback, view } = useStudio();
  const solo = useSolo();
  const scene = document.scene.value;
  const selection = document.selection.value;
  const segment = selection.kind === "transition" ? selection.index : null;
  const active = document.activeKeyframe.value;
  const keyframe = segment ?? (selection.kind === "keyframe" ? selection.index : active);
  const track = mainTrack(scene);
  const count = useSignal(2);
  const agents = useMemo(() => presentAt(track, keyframe), [track, keyframe]);
  const formation = useMemo(() => track.keyframes[keyframe]?.positions.select(agents), [track, keyframe, agents]);
  const agentCount = agents.length;
  const latest = useLatest(tieInputs(scene, keyframe), () => askModes(solo, scene, keyframe, modesToShow(agentCount)));
  const basis = latest.value?.agentCount === agentCount ? latest.value : null;
  const ties = planner.ties.value[keyframe]?.pairs ?? NO_PAIRS;
  const pairs = useMemo(() => pairsAmong(agents, ties), [agents, ties]);
  const shown = Math.max(1, Math.min(count.value, basis?.shownCount ?? 1));

  useEffect(() => {
    picture.value = basis && formation && agentCount > 0 ? { agents, formation, pairs, basis, count: shown } : null;
  }, [basis, formation, pairs, shown]);
  useEffect(() => {
    // A formation is looked at, not a motion; whoever wants it to go on plays it.
    playback.pause();
    view.projection.value = "plan";
    return () => {
      picture.value = null;
    };
  }, [playback, view]);

  return (
    <SidePanel name="Modes" title={<span class="ellipsis">{keyframeLabel(scene, keyframe)}</span>}>
      {agentCount === 0 && (
        <Note>
          {track.agents.length === 0
            ? "There is nobody on the stage yet. Draw a formation to see its modes."
            : "Everybody is absent here. Bring somebody back to see the modes of those who stand there."}
        </Note>
      )}
      {latest.problem && <Note>{latest.problem.what}</Note>}
      {agentCount > 0 && !basis && !latest.problem && <Note>Finding the modes …</Note>}
      {basis && formation && agentCount > 0 && (
        <>
          <ModeSection
            basis={basis}
            formation={formation}
            pairs={pairs}
            count={shown}
            onCount={(to) => {
              count.value = to;
            }}
          />
          {basis.shownCount < agentCount && (
            <Note>
              The first {FEW_MODES} of {formatCount(agentCount)} modes are shown.
            </Note>
          )}
          {segment !== null && <TransitionSections key={segment} solo={solo} segment={segment} />}
          {segment === null && track.segments.length > 0 && (
            <Note>Select a transition to see how these modes become those of the next formation.</Note>
          )}
        </>
      )}
    </SidePanel>
  );
}

function Note({ children }: { children: ComponentChildren }) {
  return (
    <Section>
      <p class="inspector-text" role="status">
        {children}
      </p>
    </Section>
  );
}
