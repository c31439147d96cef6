import { cutTie, resetTie, restoreTie, setTieFactor, type TieScope, WHOLE_SCENE } from "../../document/commands/ties";
import { agentColor, agentLabel, keyframeLabel } from "../../document/queries";
import { AgentDot } from "../agent-dot";
import { QuantityRow } from "../controls/quantity-row";
import { Row } from "../controls/row";
import { Segmented } from "../controls/segmented";
import { useStudio } from "../studio";
import { Head } from "./head";
import { FACTOR } from "./quantities";
import { Section } from "./section";
import { originWords, tieOrigin } from "./tie-origin";

/** A tie between two agents: how much firmer than proposed, for the whole show or at one keyframe. */
export function TiePanel({ a, b }: { a: number; b: number }) {
  const { document, planner, toolbox } = useStudio();
  const scene = document.scene.value;
  const keyframe = document.activeKeyframe.value;
  const kind = toolbox.tieScope.value;
  const scope: TieScope = kind === "scene" ? WHOLE_SCENE : { kind, index: keyframe };
  const origin = tieOrigin(scene, keyframe, a, b, planner.ties.value[keyframe] ?? null);
  const total = origin.total;

  return (
    <>
      <Head kind="Tie" aside={<span class="ellipsis">{`at ${keyframeLabel(scene, keyframe)}`}</span>}>
        <AgentDot color={agentColor(scene, a)} />
        <span class="ellipsis">{agentLabel(scene, a)}</span>
        <span class="tie-line" />
        <AgentDot color={agentColor(scene, b)} />
        <span class="ellipsis">{agentLabel(scene, b)}</span>
      </Head>
      <Section>
        {!origin.isCut && (
          <QuantityRow
            key={`${a}-${b}`}
            label="Weight"
            ends={["looser", "firmer"]}
            value={origin.byHand}
            quantity={FACTOR}
            tick={1}
            command={(factor) => setTieFactor(scope, a, b, factor)}
          />
        )}
        <Row label="From">
          <span class="row-value">{originWords(origin)}</span>
        </Row>
        {total !== null && total !== origin.byHand && (
          <Row label="In all">
            <span class="row-value number">
              {FACTOR.format(total)} <span class="unit">×</span>
            </span>
          </Row>
        )}
        <Row label="Holds for">
          <Segmented<TieScope["kind"]>
            label="Holds for"
            value={kind}
            choices={[
              { value: "scene", label: "Whole show" },
              { value: "keyframe", label: "This keyframe" },
            ]}
            onChoose={(chosen) => {
              toolbox.tieScope.value = chosen;
            }}
          />
        </Row>
        <div class="inspector-buttons">
          {origin.isCut ? (
            <button type="button" class="button" onClick={() => document.perform(restoreTie(scope, a, b))}>
              Restore tie
            </button>
          ) : (
            <>
              <button
                type="button"
                class="button"
                disabled={!origin.isByHand}
                onClick={() => document.perform(resetTie(scope, a, b))}
              >
                Back to 1×
              </button>
              <button type="button" class="button" onClick={() => document.perform(cutTie(scope, a, b))}>
                Cut tie <span class="key">Del</span>
              </button>
            </>
          )}
        </div>
      </Section>
    </>
  );
}
