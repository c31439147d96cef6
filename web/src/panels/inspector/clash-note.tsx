import { TriangleAlert } from "lucide";
import { FIRST_RECIPE } from "../../document/commands/assign";
import { takePlaces } from "../../document/commands/swap";
import { obstacleLabel } from "../../document/obstacle";
import { agentLabel, keyframeLabel } from "../../document/queries";
import { mainTrack, type Scene } from "../../document/scene";
import { formatTime, lengthWithUnit } from "../../document/units";
import type { Approach, Engine, KeyframeBreach, ObstacleApproach, SegmentReport } from "../../engine/api";
import { Icon } from "../../theme/icons";
import { Few } from "../few";
import { shutOffWords } from "../no-way";
import { useStudio } from "../studio";
import { type NextStep, nextSteps } from "./next-steps";

/** More would push the measures out of sight. */
const MOST = 3;

/** Who comes too near, how near and when, the way there, and what may help. */
export function ClashNote({ index, report }: { index: number; report: SegmentReport }) {
  const { document, playback } = useStudio();
  const scene = document.scene.value;
  const clashes = clashesOf(report);
  const breaches = report.breaches ?? [];
  const blocked = blockedOf(report);
  const goTo = (time: number) => {
    playback.pause();
    playback.seek(time);
  };
  return (
    <div class="note clash">
      <Icon node={TriangleAlert} />
      <div>
        <Few all={breaches} most={MOST}>
          {(breach) => <Standing key={JSON.stringify(breach)} scene={scene} segment={index} breach={breach} />}
        </Few>
        <Few all={clashes} most={MOST}>
          {(clash) => (
            <Meeting key={`${clash.agents} ${clash.time}`} scene={scene} clash={clash} onGo={() => goTo(clash.time)} />
          )}
        </Few>
        <Few all={report.shutOff ?? []} most={MOST}>
          {(shut) => <p key={shut.agent}>{shutOffWords(scene, shut)}</p>}
        </Few>
        <Few all={blocked} most={MOST}>
          {(at) => <Blocked key={`${at.agent} ${at.obstacle}`} scene={scene} at={at} onGo={() => goTo(at.time)} />}
        </Few>
        <NextSteps index={index} report={report} goTo={goTo} />
      </div>
    </div>
  );
}

function NextSteps({ index, report, goTo }: { index: number; report: SegmentReport; goTo(time: number): void }) {
  const { actions, document, engine } = useStudio();
  const steps = nextSteps(document.scene.value, index, report);
  if (steps.length === 0) return null;

  const take = async ({ does }: NextStep) => {
    switch (does.kind) {
      case "command":
        document.perform(does.command);
        return;
      case "keyframe":
        goTo(does.time);
        actions.get("add-keyframe").run();
        return;
      case "assign": {
        const slots = await nearestPlaces(document.scene.peek(), index, engine);
        if (slots) document.perform(takePlaces(index + 1, slots));
      }
    }
  };

  return (
    <fieldset class="next-steps" aria-label="What may help">
      {steps.map((step) => (
        <button key={step.label} type="button" class="button" onClick={() => void take(step)}>
          {step.label}
        </button>
      ))}
    </fieldset>
  );
}

/** By agent the place it takes at the end of a transition, the squared ways least in sum: around obstacles, where there are any. */
async function nearestPlaces(scene: Scene, segment: number, engine: Engine): Promise<ArrayLike<number> | null> {
  const { keyframes } = mainTrack(scene);
  const [from, to] = [keyframes[segment]?.positions, keyframes[segment + 1]?.positions];
  if (!from || !to) return null;
  if (scene.obstacles.length === 0) return engine.assign(from, to);
  const recipe = { ...FIRST_RECIPE, cost: "squared" } as const;
  const found = await engine.findPlaces(scene, { segment, recipe, isFlipped: false, isPredicted: false }, () => {});
  return found?.slots ?? null;
}

function Meeting({ scene, clash, onGo }: { scene: Scene; clash: Approach; onGo(): void }) {
  const [first, second] = clash.agents;
  return (
    <p>
      Agents {agentLabel(scene, first)} and {agentLabel(scene, second)} come within{" "}
      {lengthWithUnit(clash.distance, scene.stage.units)} at {formatTime(clash.time)}.{" "}
      <button type="button" class="link" onClick={onGo}>
        Go there
      </button>
    </p>
  );
}

function Blocked({ scene, at, onGo }: { scene: Scene; at: ObstacleApproach; onGo(): void }) {
  const near = lengthWithUnit(Math.abs(at.distance), scene.stage.units);
  const how = at.distance > 0 ? `comes within ${near} of` : `comes ${near} inside`;
  return (
    <p>
      Agent {agentLabel(scene, at.agent)} {how} {obstacleLabel(scene, at.obstacle)} at {formatTime(at.time)}.{" "}
      <button type="button" class="link" onClick={onGo}>
        Go there
      </button>
    </p>
  );
}

/** Who is too near in a keyframe already: nothing on the way can mend that. */
function Standing({ scene, segment, breach }: { scene: Scene; segment: number; breach: KeyframeBreach }) {
  const { document } = useStudio();
  const { agent, other, distance } = breach;
  const index = segment + breach.end;
  const isInside = distance < 0;
  const near = `${lengthWithUnit(Math.abs(distance), scene.stage.units)} ${isInside ? "inside" : "from"}`;
  const whom = "agent" in other ? `agent ${agentLabel(scene, other.agent)}` : obstacleLabel(scene, other.obstacle);
  return (
    <p>
      Agent {agentLabel(scene, agent)} stands {near} {whom} in{" "}
      <button
        type="button"
        class="link"
        onClick={() => {
          document.selection.value = { kind: "keyframe", index };
        }}
      >
        {keyframeLabel(scene, index)}
      </button>
      {isInside ? ". A keyframe is never changed: move them or the obstacle." : "."}
    </p>
  );
}

/** The meetings that are too near, worst first; without avoidance the worst alone is known. */
function clashesOf({ clearance, unsolved, blocked = [], breaches = [] }: SegmentReport): readonly Approach[] {
  if (unsolved && unsolved.length + blocked.length > 0) return [...unsolved].sort((a, b) => a.distance - b.distance);
  return clearance && breaches.length === 0 ? [clearance] : [];
}

/** Who could not be led around an obstacle, worst first; whoever stands there or has no way is named with that. */
function blockedOf({ blocked = [], breaches = [], shutOff = [] }: SegmentReport): readonly ObstacleApproach[] {
  const stands = ({ agent, obstacle }: ObstacleApproach) =>
    breaches.some(({ agent: who, other }) => who === agent && "obstacle" in other && other.obstacle === obstacle);
  const isShutOff = ({ agent }: ObstacleApproach) => shutOff.some((shut) => shut.agent === agent);
  return blocked.filter((at) => !stands(at) && !isShutOff(at)).sort((a, b) => a.distance - b.distance);
}
