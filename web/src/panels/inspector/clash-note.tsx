import { TriangleAlert } from "lucide";
import { agentLabel } from "../../document/queries";
import { formatTime, lengthWithUnit } from "../../document/units";
import type { SegmentReport } from "../../engine/api";
import { Icon } from "../../theme/icons";
import { useStudio } from "../studio";

/** Who comes too near, how near and when, and the way there. */
export function ClashNote({ report }: { report: SegmentReport }) {
  const { document, playback } = useStudio();
  const scene = document.scene.value;
  const worst = report.clearance;
  if (!worst) return null;
  const [first, second] = worst.agents;
  return (
    <div class="note clash">
      <Icon node={TriangleAlert} />
      <p>
        Agents {agentLabel(scene, first)} and {agentLabel(scene, second)} come within{" "}
        {lengthWithUnit(worst.distance, scene.stage.units)} at {formatTime(worst.time)}.{" "}
        <button
          type="button"
          class="link"
          onClick={() => {
            playback.pause();
            playback.seek(worst.time);
          }}
        >
          Go there
        </button>
      </p>
    </div>
  );
}
