import { setFrameRate, setJoin, setStage, setTempo, setTension } from "../../document/commands/scene";
import { LIMITS } from "../../document/limits";
import { type Backdrop, mainTrack, type Scene, type Units } from "../../document/scene";
import { metersPer } from "../../document/units";
import { NumberBox } from "../controls/number-box";
import { QuantityRow } from "../controls/quantity-row";
import { Row } from "../controls/row";
import { Segmented } from "../controls/segmented";
import { Select } from "../controls/select";
import { useStudio } from "../studio";
import { GroupList } from "./group-list";
import { Head } from "./head";
import { MinimumDistanceRow } from "./minimum-distance-row";
import { ProposeGroups } from "./propose-groups";
import { isLongUnit, sizeQuantity, TENSION, USUAL_TENSION, wholeQuantity } from "./quantities";
import { Section } from "./section";
import { JOINS } from "./words";

const BACKDROPS: readonly { value: Backdrop; label: string }[] = [
  { value: "grid", label: "Grid" },
  { value: "none", label: "Plain" },
  { value: "stage", label: "Theater stage" },
  { value: "football-college", label: "Football field, college" },
  { value: "football-hs", label: "Football field, high school" },
  { value: "soccer", label: "Soccer field" },
];

/** Backdrops that have a size of their own. */
const FIELDS: ReadonlySet<Backdrop> = new Set(["football-college", "football-hs", "soccer"]);

const UNITS: readonly { value: Units; label: string }[] = [
  { value: "m", label: "m" },
  { value: "ft", label: "ft" },
  { value: "yd", label: "yd" },
  { value: "steps", label: "steps" },
];

const FRAME_RATE = wholeQuantity(LIMITS.frameRate.min, LIMITS.frameRate.max, "/s");
const BEATS = wholeQuantity(1, 400, "/min");
const BEATS_PER_BAR = wholeQuantity(1, 32);

/** What holds for the whole scene, when nothing in it is selected. */
export function ScenePanel() {
  const { document } = useStudio();
  const scene = document.scene.value;
  const { stage, tempo } = scene;
  const isEmpty = mainTrack(scene).agents.length === 0;

  async function tie(base: Scene["adjacency"]["base"]): Promise<void> {
    const { setBase, WHOLE_SCENE } = await import("../../document/commands/ties");
    document.perform(setBase(WHOLE_SCENE, base));
  }

  return (
    <>
      <Head kind="Scene">{scene.title || "Untitled"}</Head>
      <Section>
        <Row label="Backdrop">
          <Select
            label="Backdrop"
            value={stage.backdrop}
            choices={BACKDROPS}
            onChoose={(backdrop) => document.perform(setStage({ backdrop }))}
          />
        </Row>
        {!FIELDS.has(stage.backdrop) && <SizeRow />}
        <Row label="Units">
          <Segmented
            label="Units"
            value={stage.units}
            choices={UNITS}
            onChoose={(units) => document.perform(setStage({ units }))}
          />
        </Row>
        <MinimumDistanceRow />
        <JoinRows />
        <Row label="Frame rate">
          <NumberBox
            label="Frame rate"
            value={scene.frameRate}
            quantity={FRAME_RATE}
            onCommit={(value) => document.perform(setFrameRate(value))}
          />
        </Row>
        <Row label="Tempo">
          <span class="pair">
            <NumberBox
              label="Beats per minute"
              value={tempo.beatsPerMinute}
              quantity={BEATS}
              onCommit={(beatsPerMinute) => document.perform(setTempo({ beatsPerMinute }))}
            />
            <NumberBox
              label="Beats per bar"
              prefix="bar"
              value={tempo.beatsPerBar}
              quantity={BEATS_PER_BAR}
              onCommit={(value) => document.perform(setTempo({ beatsPerBar: Math.round(value) }))}
            />
          </span>
        </Row>
        <Row label="Ties">
          <Select
            label="Proposed ties"
            value={scene.adjacency.base}
            choices={[
              { value: "delaunay", label: "Between neighbors" },
              { value: "none", label: "Only by hand" },
            ]}
            onChoose={(base) => void tie(base)}
          />
        </Row>
      </Section>
      {isEmpty ? <BringOneIn /> : <GroupList parent={[]} title="Groups" />}
      <ProposeGroups inside={[]} />
    </>
  );
}

function JoinRows() {
  const { document } = useStudio();
  const { join, tension } = document.scene.value;
  return (
    <>
      <Row label="Join">
        <Select label="Join" value={join} choices={JOINS} onChoose={(chosen) => document.perform(setJoin(chosen))} />
      </Row>
      <p class="inspector-text row-text">{JOINS.find((word) => word.value === join)?.text}</p>
      {join === "smooth" && (
        <QuantityRow
          label="Tension"
          ends={["stiff", "loose"]}
          value={tension}
          quantity={TENSION}
          tick={USUAL_TENSION}
          command={setTension}
        />
      )}
    </>
  );
}

function SizeRow() {
  const { document } = useStudio();
  const { stage } = document.scene.value;
  const per = metersPer(stage.units);
  const quantity = sizeQuantity(stage.units);
  const isUnitBeside = isLongUnit(stage.units);
  return (
    <Row label="Size" {...(isUnitBeside ? { note: stage.units } : {})}>
      <span class="pair">
        <NumberBox
          label="Stage width"
          prefix="w"
          value={stage.width / per}
          quantity={quantity}
          isUnitBeside={isUnitBeside}
          onCommit={(width) => document.perform(setStage({ width: width * per }))}
        />
        <NumberBox
          label="Stage depth"
          prefix="d"
          value={stage.depth / per}
          quantity={quantity}
          isUnitBeside={isUnitBeside}
          onCommit={(depth) => document.perform(setStage({ depth: depth * per }))}
        />
      </span>
    </Row>
  );
}

function BringOneIn() {
  const { actions } = useStudio();
  return (
    <Section title="Bring one in">
      <p class="inspector-text">
        Drop a scene, a keyframe CSV or a link anywhere on this page, or start from an example.
      </p>
      <button type="button" class="button" onClick={() => actions.get("open").run()}>
        Choose a file
      </button>
    </Section>
  );
}
