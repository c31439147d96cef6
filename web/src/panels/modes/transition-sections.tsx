import { keyframeLabel } from "../../document/queries";
import { mainTrack } from "../../document/scene";
import { tieInputs } from "../../engine/inputs";
import { askModesBetween, MATCH_ORDERS, type ModeMatch } from "../../engine/modes";
import type { Solo } from "../../engine/solo";
import { Section } from "../inspector/section";
import { orderWord } from "../inspector/words";
import { useStudio } from "../studio";
import { BetweenPlot } from "./between-plot";
import { useLatest } from "./latest";
import { LikenessMap } from "./likeness-map";
import { ALL_UP_TO, modesToShow } from "./limits";
import { likenessAlong } from "./mode-geometry";

/** Instants that eigenvalues are found at on the way; each costs an eigenproblem. */
const STEPS = 16;

/** How the modes of a transition's ends fit, order by order, and how their eigenvalues run. */
export function TransitionSections({ solo, segment }: { solo: Solo; segment: number }) {
  const { document, planner } = useStudio();
  const scene = document.scene.value;
  const agentCount = mainTrack(scene).agents.length;
  const steps = agentCount <= ALL_UP_TO ? STEPS : 0;
  const inputs = [...tieInputs(scene, segment), ...tieInputs(scene, segment + 1)];
  const { value, problem } = useLatest(inputs, () =>
    askModesBetween(solo, scene, segment, { most: modesToShow(agentCount), steps }),
  );
  const [from, to] = [keyframeLabel(scene, segment), keyframeLabel(scene, segment + 1)];
  const planning = planner.segments.value[segment];
  const choice = planning?.kind === "ready" ? planning.plan.report.choice : null;
  if (problem) return <p class="inspector-text modes-waiting">{problem.what}</p>;
  if (!value)
    return (
      <p class="inspector-text modes-waiting">
        Comparing the modes of {from} and {to} …
      </p>
    );
  return (
    <>
      <Section title="Which mode becomes which" note="firm: alike">
        <div class="likeness-maps">
          {MATCH_ORDERS.map((order, index) => (
            <LikenessMap
              key={order}
              name={orderWord(order)}
              match={value.match}
              order={index}
              isUsed={choice?.method === "spectral" && choice.order === order}
              {...likenessAlong(amountsAlong(value.match, index))}
            />
          ))}
        </div>
        <p class="inspector-text modes-caption">
          A row is a mode of {from}, a column the mode of {to} that the order gives it. The firmer the diagonal, the
          less the modes have to turn on the way.
        </p>
      </Section>
      {value.eigenvalues.length > 0 && (
        <Section title="Eigenvalues on the way" note={`${from} → ${to}`}>
          <BetweenPlot eigenvalues={value.eigenvalues} modeCount={value.modeCount} segment={segment} />
          <p class="inspector-text modes-caption">
            Of a graph whose ties go evenly from those of {from} to those of {to}. Where lines come close, modes change
            places, and pairing them by eigenvalue winds the paths.
          </p>
        </Section>
      )}
    </>
  );
}

function amountsAlong(match: ModeMatch, order: number): number[] {
  return Array.from(match.targets(order), (target, source) => match.amount(source, target));
}
