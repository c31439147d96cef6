import { membershipOf, memberships, moveToGroup } from "../../document/commands/membership";
import { Row } from "../controls/row";
import { Select } from "../controls/select";
import { useStudio } from "../studio";

const SEVERAL = "several";

/** Which group agents are in, innermost; choosing another moves them there. */
export function MembershipRow({ agents }: { agents: ReadonlySet<number> }) {
  const { document } = useStudio();
  const scene = document.scene.value;
  const all = memberships(scene);
  if (all.length === 1) return null;
  const homes = new Set([...agents].map((agent) => membershipOf(scene, agent)));
  const [home = SEVERAL] = homes;
  const isMixed = homes.size !== 1;
  const choices = all.map(({ key, label }) => ({ value: key, label }));
  return (
    <Row label="Group">
      <Select
        label="Group"
        value={isMixed ? SEVERAL : home}
        choices={isMixed ? [{ value: SEVERAL, label: "Several" }, ...choices] : choices}
        onChoose={(key) => {
          const chosen = all.find((entry) => entry.key === key);
          if (chosen) document.perform(moveToGroup(chosen.path, agents));
        }}
      />
    </Row>
  );
}
