import { nodeAt, setNode } from "../../document/commands/nodes";
import { setTransition } from "../../document/commands/transitions";
import { groupPaths } from "../../document/groups";
import { groupLabel } from "../../document/queries";
import type { Choice, GroupPath, MethodName, Scene, Segment } from "../../document/scene";
import { QuantityRow } from "../controls/quantity-row";
import { Row } from "../controls/row";
import { Select } from "../controls/select";
import { Switch } from "../controls/switch";
import { useStudio } from "../studio";
import { SHARE } from "./quantities";
import { PLAIN_METHODS } from "./words";

const INHERITED = "inherited";
const NOBODY = "nobody";

/** Whether groups move as wholes, and which of them by a way of their own. */
export function HierarchyRows(props: { index: number; segment: Segment; choice: Choice | null }) {
  const { document } = useStudio();
  const { index, segment } = props;
  const scene = document.scene.value;
  const own = segment.nodes.map((node) => node.group);
  const others = [[], ...groupPaths(scene.groups)].filter((path) => nodeAt(segment, path) === null);
  return (
    <>
      <Switch
        label="Hierarchy"
        note="groups as wholes"
        isOn={segment.hierarchy}
        onToggle={(hierarchy) => document.perform(setTransition(index, { hierarchy }))}
      />
      {segment.hierarchy && scene.groups.length === 0 && (
        <p class="inspector-text">There are no groups yet, so everybody moves as one.</p>
      )}
      {segment.hierarchy && own.map((path) => <NodeRows key={path.join(".")} path={path} {...props} />)}
      {segment.hierarchy && scene.groups.length > 0 && others.length > 0 && (
        <Row label="Another way">
          <Select
            label="Another way for"
            value={NOBODY}
            choices={[
              { value: NOBODY, label: "Choose a group" },
              ...others.map((path) => ({ value: keyOf(path), label: nameOf(scene, path) })),
            ]}
            onChoose={(key) => {
              const path = others.find((other) => keyOf(other) === key);
              if (path) document.perform(setNode(index, path, { method: usual(props.choice), blend: null }));
            }}
          />
        </Row>
      )}
    </>
  );
}

function NodeRows({ index, segment, path }: { index: number; segment: Segment; path: GroupPath }) {
  const { document } = useStudio();
  const node = nodeAt(segment, path);
  if (!node) return null;
  const { blend } = node;
  const name = nameOf(document.scene.value, path);
  const set = (change: Partial<typeof node>) => setNode(index, path, { method: node.method, blend, ...change });
  return (
    <>
      <Row label={name}>
        <Select
          label={`Method of ${name}`}
          value={node.method}
          choices={[...PLAIN_METHODS, { value: INHERITED, label: "As the transition" }]}
          onChoose={(method) => document.perform(method === INHERITED ? setNode(index, path, null) : set({ method }))}
        />
      </Row>
      <Row label="" note="blended with">
        <Select
          label={`Blend of ${name}`}
          value={blend?.method ?? INHERITED}
          choices={[{ value: INHERITED, label: "Nothing" }, ...PLAIN_METHODS]}
          onChoose={(method) =>
            document.perform(
              set({ blend: method === INHERITED ? null : { method, amount: blend?.amount ?? FIRST_AMOUNT } }),
            )
          }
        />
      </Row>
      {blend && (
        <QuantityRow
          label={`Amount of ${name}`}
          shortLabel=""
          note="by"
          value={blend.amount}
          quantity={SHARE}
          command={(amount) => set({ blend: { ...blend, amount } })}
        />
      )}
    </>
  );
}

const FIRST_AMOUNT = 0.5;

/** A way that changes nothing at first, where it is known. */
function usual(choice: Choice | null): MethodName {
  return choice?.method ?? "spectral";
}

function keyOf(path: GroupPath): string {
  return path.length > 0 ? path.join(".") : "everybody";
}

function nameOf(scene: Scene, path: GroupPath): string {
  return path.length > 0 ? groupLabel(scene, path) : "Everybody";
}
