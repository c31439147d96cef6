import { groupAt, groupSet } from "../../document/groups";
import { groupColor, groupLabel } from "../../document/queries";
import type { GroupPath } from "../../document/scene";
import { formatCount } from "../../document/units";
import { AgentDot } from "../agent-dot";
import { useStudio } from "../studio";
import { Section } from "./section";

/** The groups directly within one, or the outermost ones; each leads to itself. */
export function GroupList({ parent, title }: { parent: GroupPath; title: string }) {
  const { document } = useStudio();
  const scene = document.scene.value;
  const groups = parent.length > 0 ? (groupAt(scene.groups, parent)?.children ?? []) : scene.groups;
  if (groups.length === 0) return null;
  return (
    <Section title={title}>
      <ul class="group-list">
        {groups.map((group, index) => {
          const path = [...parent, index];
          return (
            <li key={path.join(".")}>
              <button
                type="button"
                onClick={() => {
                  document.selection.value = { kind: "group", path };
                }}
              >
                <AgentDot color={groupColor(scene, path)} />
                <span class="ellipsis">{groupLabel(scene, path)}</span>
                <span class="number unit">{formatCount(groupSet(group).size)}</span>
              </button>
            </li>
          );
        })}
      </ul>
    </Section>
  );
}
