import { rippleKeyframe } from "../../document/commands/retime";
import { LIMITS, SHORTEST_TRANSITION } from "../../document/limits";
import { keyframeLabel } from "../../document/queries";
import { mainTrack } from "../../document/scene";
import { endsAround } from "../../document/stretches";
import { WordAction } from "../action-button";
import { lazily } from "../lazily";
import { usePlanningWorthSaying } from "../stage-edge/use-planning-worth-saying";
import { StatusPill } from "../status";
import { useStudio } from "../studio";
import { Candidates } from "./candidates";
import { ClashNote } from "./clash-note";
import { Head } from "./head";
import { MannerOptions } from "./manner-options";
import { Measures } from "./measures";
import { PlanningNote } from "./planning-note";
import { planningView } from "./planning-view";
import { Section } from "./section";
import { SpanRow } from "./span-row";
import { TransitionOptions } from "./transition-options";

const AssignmentPart = lazily(() => import("../assignment/assignment-part").then((part) => part.AssignmentPart));
const PathPart = lazily(() => import("../travel/path-part").then((part) => part.PathPart));
const HurryNote = lazily(() => import("./hurry-note").then((part) => part.HurryNote));
const SpreadOut = lazily(() => import("./spread-out").then((part) => part.SpreadOut));

/** How one formation becomes the next, how well, and why so. */
export function TransitionPanel({ index }: { index: number }) {
  const { document, planner } = useStudio();
  const isLong = usePlanningWorthSaying();
  const scene = document.scene.value;
  const track = mainTrack(scene);
  const segment = track.segments[index];
  const [from, to] = [track.keyframes[index], track.keyframes[index + 1]];
  if (!segment || !from || !to) return null;
  const [source, target] = endsAround(track, index);
  const isPart = target - source > 1;
  const leaving = from.time + from.hold;
  const view = planningView(planner.segments.value[index], scene.minimumDistance, scene.stage.units);
  const choice = view.plan?.report.choice ?? segment.chosen;
  const isFormer = view.isFormer && isLong.value;
  return (
    <>
      <Head kind="Transition" aside={view.words && <StatusPill status={view.status}>{view.words}</StatusPill>}>
        <span class="ellipsis">{keyframeLabel(scene, index)}</span>
        <span class="arrow">→</span>
        <span class="ellipsis">{keyframeLabel(scene, index + 1)}</span>
      </Head>
      <Section>
        {isPart && (
          <p class="inspector-text">
            {`A part of ${keyframeLabel(scene, source)} → ${keyframeLabel(scene, target)}: what is chosen here is for all of it.`}
          </p>
        )}
        <SpanRow
          label="Duration"
          value={to.time - leaving}
          min={SHORTEST_TRANSITION}
          max={LIMITS.seconds}
          onCommit={(seconds) => document.perform(rippleKeyframe(index + 1, leaving + seconds))}
        />
        <TransitionOptions index={index} segment={segment} choice={choice} />
        <PlanningNote view={view} />
        {view.plan && view.status === "clash" && <ClashNote index={index} report={view.plan.report} />}
        {view.plan?.report.hurried && !isFormer && <HurryNote index={index} hurried={view.plan.report.hurried} />}
        {segment.avoidance && <SpreadOut key={index} index={index} report={view.plan?.report ?? null} />}
      </Section>
      {view.plan && <Measures plan={view.plan} index={index} isFormer={isFormer} />}
      {view.plan && <Candidates report={view.plan.report} isAuto={segment.method === "auto"} isFormer={isFormer} />}
      <Section>
        <div class="inspector-buttons">
          <WordAction id="compare" class="button">
            Compare side by side
          </WordAction>
          <WordAction id="modes" class="button">
            Modes
          </WordAction>
          {track.segments.length > 1 && (
            <WordAction id="use-everywhere" class="button">
              Use for every transition
            </WordAction>
          )}
        </div>
      </Section>
      {isPart ? null : <AssignmentPart key={index} index={index} segment={segment} />}
      <PathPart key={`path ${index}`} index={index} segment={segment} />
      <Section title="Manner">
        <MannerOptions index={index} segment={segment} choice={choice} />
      </Section>
    </>
  );
}
