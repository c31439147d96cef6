import { useSignal } from "@preact/signals";
import { cutsBetween, factorBetween, pairsBetween, weighTies } from "../../document/commands/group-ties";
import { adjacencyAt, WHOLE_SCENE } from "../../document/commands/ties";
import { groupAt, groupPaths, groupSet } from "../../document/groups";
import { groupLabel } from "../../document/queries";
import type { GroupPath } from "../../document/scene";
import { QuantityRow } from "../controls/quantity-row";
import { Row } from "../controls/row";
import { Select } from "../controls/select";
import { useStudio } from "../studio";
import { FACTOR } from "./quantities";
import { Section } from "./section";

const NONE = "none";

/** How firmly a group keeps to another: firmer ties merge them, cut ones split them. */
export function TiesBetween({ path }: { path: GroupPath }) {
  const { document } = useStudio();
  const chosen = useSignal(NONE);
  const scene = document.scene.value;
  const group = groupAt(scene.groups, path);
  const others = groupPaths(scene.groups).filter((other) => areApart(path, other));
  if (!group || others.length === 0) return null;

  const other = others.find((candidate) => candidate.join(".") === chosen.value);
  return (
    <Section title="Between groups">
      <Row label="Ties to">
        <Select
          label="Ties to"
          value={other ? chosen.value : NONE}
          choices={[
            { value: NONE, label: "Choose a group" },
            ...others.map((candidate) => ({ value: candidate.join("."), label: groupLabel(scene, candidate) })),
          ]}
          onChoose={(key) => {
            chosen.value = key;
          }}
        />
      </Row>
      {other && <Between one={groupSet(group)} other={groupSet(groupAt(scene.groups, other) ?? group)} />}
    </Section>
  );
}

function Between({ one, other }: { one: ReadonlySet<number>; other: ReadonlySet<number> }) {
  const { document, planner } = useStudio();
  const scene = document.scene.value;
  const adjacency = adjacencyAt(scene, document.activeKeyframe.value);
  const cuts = cutsBetween(adjacency, one, other);
  const pairs = [
    ...pairsBetween(
      planner.ties.value.map((list) => list?.pairs ?? null),
      one,
      other,
    ),
    ...cuts,
  ];
  if (pairs.length === 0) return <p class="inspector-text">No tie runs between them at any keyframe.</p>;
  const factor = factorBetween(adjacency, pairs);
  const weigh = (value: number) => weighTies(WHOLE_SCENE, pairs, value);
  return (
    <>
      {factor > 0 ? (
        <QuantityRow
          label="Ties between"
          shortLabel="Weight"
          value={factor}
          quantity={FACTOR}
          tick={1}
          command={weigh}
        />
      ) : (
        <p class="inspector-text">{pairs.length === 1 ? "The tie is cut." : `All ${pairs.length} ties are cut.`}</p>
      )}
      <div class="inspector-buttons">
        <button type="button" class="button" disabled={factor === 0} onClick={() => document.perform(weigh(0))}>
          Split
        </button>
        <button type="button" class="button" disabled={factor === 1} onClick={() => document.perform(weigh(1))}>
          As proposed
        </button>
      </div>
    </>
  );
}

/** Neither is inside of the other. */
function areApart(one: GroupPath, other: GroupPath): boolean {
  const depth = Math.min(one.length, other.length);
  return one.slice(0, depth).some((step, level) => step !== other[level]);
}
