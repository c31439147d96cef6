import { setAbsent } from "../../document/commands/absence";
import { agentLabel } from "../../document/queries";
import { mainTrack } from "../../document/scene";
import { formatCount } from "../../document/units";
import { useStudio } from "../studio";

/** More are counted, not listed. */
const MOST_LISTED = 4;

/** Who is absent from a keyframe. */
export function AbsenceNote({ index }: { index: number }) {
  const { document } = useStudio();
  const scene = document.scene.value;
  const absent = mainTrack(scene).keyframes[index]?.absent ?? [];
  if (absent.length === 0) return null;
  const labels = absent.map((agent) => agentLabel(scene, agent));
  const names =
    absent.length > MOST_LISTED
      ? `${formatCount(absent.length)} agents are`
      : `${absent.length === 1 ? "Agent" : "Agents"} ${labels.join(", ")} ${absent.length === 1 ? "is" : "are"}`;
  return (
    <>
      <p class="inspector-text">
        {names} absent here: hollow where they leave to, and neither measured nor kept apart while the others stand.
      </p>
      <div class="inspector-buttons">
        <button
          type="button"
          class="button"
          onClick={() => {
            document.selection.value = { kind: "agents", agents: new Set(absent) };
          }}
        >
          Select the absent
        </button>
        <button type="button" class="button" onClick={() => document.perform(setAbsent(index, new Set(absent), false))}>
          Bring all back
        </button>
      </div>
    </>
  );
}
