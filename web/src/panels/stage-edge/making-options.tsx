import { LIMITS } from "../../document/limits";
import { mainTrack } from "../../document/scene";
import { metersPer } from "../../document/units";
import type { Spacing } from "../../tools/toolbox";
import { NumberBox } from "../controls/number-box";
import { Segmented } from "../controls/segmented";
import { lengthQuantity, wholeQuantity } from "../inspector/quantities";
import { useStudio } from "../studio";
import { ShapeChoice } from "./shape-choice";
import { noteBefore, usePlacement } from "./use-placement";

const AGENT_COUNT = wholeQuantity(1, LIMITS.agents);

/** A count of this many, or an interval of this many meters, when a person changes from one to the other. */
const FIRST: { readonly [by in Spacing["by"]]: Spacing } = {
  count: { by: "count", count: 24 },
  interval: { by: "interval", meters: 1 },
};

/** What Draw and Shape make: which shape, and how many agents or how far apart. */
export function MakingOptions({ tool }: { tool: "draw" | "shape" }) {
  return (
    <fieldset class="floating tool-options" data-tool={tool} aria-label={tool === "draw" ? "Drawing" : "Shapes"}>
      {tool === "shape" && (
        <>
          <ShapeChoice />
          <ShapeOrigins />
        </>
      )}
      <AgentSpacing />
    </fieldset>
  );
}

/** Shapes that are no geometry. */
function ShapeOrigins() {
  const { actions } = useStudio();
  return (
    <div class="shape-origins">
      <button type="button" class="button" onClick={() => actions.get("shape-from-picture").run()}>
        Picture…
      </button>
      <button type="button" class="button" onClick={() => actions.get("shape-from-text").run()}>
        Text…
      </button>
    </div>
  );
}

function AgentSpacing() {
  const { document, toolbox } = useStudio();
  const scene = document.scene.value;
  const spacing = toolbox.spacing.value;
  const ahead = usePlacement();
  const { placement } = ahead;
  const note = noteBefore(ahead, mainTrack(scene).keyframes.length, spacing.by === "count" ? spacing.count : null);
  const said = note !== null && (
    <p class="tool-reason" id="agents-reason">
      {note}
    </p>
  );
  const describedBy = note === null ? undefined : "agents-reason";
  if (placement.kind === "place") {
    return (
      <>
        <NumberBox
          label="Agents"
          prefix="Agents"
          value={placement.agents.length}
          quantity={AGENT_COUNT}
          isDisabled
          describedBy={describedBy}
          onCommit={() => undefined}
        />
        {said}
      </>
    );
  }
  const { units } = scene.stage;
  const per = metersPer(units);
  return (
    <>
      {spacing.by === "count" ? (
        <NumberBox
          label="Agents"
          prefix="Agents"
          value={spacing.count}
          quantity={AGENT_COUNT}
          isLive
          describedBy={describedBy}
          onCommit={(count) => {
            toolbox.spacing.value = { by: "count", count: Math.round(count) };
          }}
        />
      ) : (
        <NumberBox
          label="Interval"
          prefix="Every"
          value={spacing.meters / per}
          quantity={lengthQuantity(units, { min: 0.05, max: 100, step: 0.25 })}
          isLive
          onCommit={(length) => {
            toolbox.spacing.value = { by: "interval", meters: length * per };
          }}
        />
      )}
      <Segmented<Spacing["by"]>
        label="Spacing"
        value={spacing.by}
        choices={[
          { value: "count", label: "Count" },
          { value: "interval", label: "Interval" },
        ]}
        onChoose={(by) => {
          if (by !== spacing.by) toolbox.spacing.value = FIRST[by];
        }}
      />
      {said}
    </>
  );
}
