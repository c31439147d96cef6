import { colorGroup, dissolveGroup, nestGroup, renameGroup, setGroupTieWeight } from "../../document/commands/groups";
import { groupAt, groupPaths, groupSet } from "../../document/groups";
import { groupColor, groupLabel } from "../../document/queries";
import type { GroupPath } from "../../document/scene";
import { formatCount } from "../../document/units";
import { AgentDot } from "../agent-dot";
import { ColorRow } from "../controls/color-row";
import { QuantityRow } from "../controls/quantity-row";
import { Row } from "../controls/row";
import { Select } from "../controls/select";
import { Switch } from "../controls/switch";
import { useStudio } from "../studio";
import { GroupList } from "./group-list";
import { Head } from "./head";
import { NameRow } from "./name-row";
import { ProposeGroups } from "./propose-groups";
import { FACTOR } from "./quantities";
import { Section } from "./section";
import { TiesBetween } from "./ties-between";

/** How firmly a group is tied when a person first asks for it. */
const FIRST_FACTOR = 10;
const TOP = "top";

/** A named subset: what it is called, how firmly it keeps together, what it is in and what is in it. */
export function GroupPanel({ path }: { path: GroupPath }) {
  const { document } = useStudio();
  const scene = document.scene.value;
  const group = groupAt(scene.groups, path);
  if (!group) return null;
  const agents = groupSet(group);
  const count = `${formatCount(agents.size)} ${agents.size === 1 ? "agent" : "agents"}`;
  const color = groupColor(scene, path);
  return (
    <>
      <Head kind="Group" aside={<span class="number">{count}</span>}>
        <AgentDot color={color} />
        <span class="ellipsis">{groupLabel(scene, path)}</span>
      </Head>
      <Section>
        <NameRow
          key={path.join(".")}
          name={group.name}
          label={groupLabel(scene, path)}
          onCommit={(name) => document.perform(renameGroup(path, name))}
        />
        <Switch
          label="Ties inside"
          isOn={group.tieWeight !== null}
          onToggle={(isOn) => document.perform(setGroupTieWeight(path, isOn ? FIRST_FACTOR : null))}
        />
        {group.tieWeight !== null && (
          <QuantityRow
            label="Weight"
            ends={["looser", "firmer"]}
            value={group.tieWeight}
            quantity={FACTOR}
            tick={1}
            command={(factor) => setGroupTieWeight(path, factor)}
          />
        )}
        <InsideOfRow path={path} />
        <ColorRow
          label="Color"
          color={group.color}
          shown={color}
          onChoose={(chosen) => document.perform(colorGroup(path, chosen))}
        />
        <div class="inspector-buttons">
          <button
            type="button"
            class="button"
            onClick={() => {
              document.selection.value = { kind: "agents", agents };
            }}
          >
            Pick its agents
          </button>
          <button type="button" class="button" onClick={() => document.perform(dissolveGroup(path))}>
            Dissolve
          </button>
        </div>
      </Section>
      <GroupList parent={path} title="Groups in it" />
      <ProposeGroups inside={path} />
      <TiesBetween key={path.join(".")} path={path} />
    </>
  );
}

function InsideOfRow({ path }: { path: GroupPath }) {
  const { document } = useStudio();
  const scene = document.scene.value;
  const hosts = groupPaths(scene.groups).filter((other) => !path.every((step, depth) => other[depth] === step));
  if (hosts.length === 0) return null;
  const parent = path.slice(0, -1);
  return (
    <Row label="Inside of">
      <Select
        label="Inside of"
        value={parent.length > 0 ? parent.join(".") : TOP}
        choices={[
          { value: TOP, label: "No other group" },
          ...hosts.map((host) => ({ value: host.join("."), label: groupLabel(scene, host) })),
        ]}
        onChoose={(key) => document.perform(nestGroup(path, hosts.find((host) => host.join(".") === key) ?? []))}
      />
    </Row>
  );
}
