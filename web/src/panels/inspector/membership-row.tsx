import { addToGroup, removeFromGroup } from "../../document/commands/groups";
import { groupOf, groupPaths } from "../../document/groups";
import { groupLabel } from "../../document/queries";
import type { GroupPath } from "../../document/scene";
import { Row } from "../controls/row";
import { Select } from "../controls/select";
import { useStudio } from "../studio";

const NONE = "none";
const SEVERAL = "several";

/** Which group agents are in, innermost; choosing another moves them there. */
export function MembershipRow({ agents }: { agents: ReadonlySet<number> }) {
  const { document } = useStudio();
  const scene = document.scene.value;
  const paths = groupPaths(scene.groups);
  if (paths.length === 0) return null;
  const homes = new Set([...agents].map((agent) => keyOf(groupOf(scene.groups, agent))));
  const [home = NONE] = homes;
  const isMixed = homes.size > 1;

  function move(key: string): void {
    const path = paths.find((other) => keyOf(other) === key);
    if (path) document.perform(addToGroup(path, agents));
    else if (key === NONE) document.perform(leaveGroups(scene.groups.length, agents));
  }

  return (
    <Row label="Group">
      <Select
        label="Group"
        value={isMixed ? SEVERAL : home}
        choices={[
          ...(isMixed ? [{ value: SEVERAL, label: "Several" }] : []),
          { value: NONE, label: "None" },
          ...paths.map((path) => ({ value: keyOf(path), label: fullLabel(path) })),
        ]}
        onChoose={move}
      />
    </Row>
  );

  function fullLabel(path: GroupPath): string {
    return path.map((_, depth) => groupLabel(scene, path.slice(0, depth + 1))).join(" / ");
  }
}

function keyOf(path: GroupPath | null): string {
  return path ? path.join(".") : NONE;
}

function leaveGroups(topCount: number, agents: ReadonlySet<number>) {
  return {
    label: "Remove from group",
    apply: (scene: Parameters<ReturnType<typeof removeFromGroup>["apply"]>[0]) => {
      let left = scene;
      // Backwards: a group that is left empty goes, and those after it move up.
      for (let top = topCount - 1; top >= 0; top -= 1) left = removeFromGroup([top], agents).apply(left);
      return left;
    },
  };
}
