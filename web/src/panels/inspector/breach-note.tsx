import { TriangleAlert } from "lucide";
import { agentLabel } from "../../document/queries";
import { mainTrack } from "../../document/scene";
import { lengthWithUnit } from "../../document/units";
import { Icon } from "../../theme/icons";
import { breachesOf } from "../breaches";
import { useStudio } from "../studio";

/** More would push the panel's own rows out of sight. */
const MOST = 5;

/** Who stands too near in a keyframe. Nobody moves them: a keyframe is the person's. */
export function BreachNote({ index }: { index: number }) {
  const { document } = useStudio();
  const scene = document.scene.value;
  const formation = mainTrack(scene).keyframes[index]?.positions;
  const breaches = formation ? breachesOf(formation, scene.minimumDistance) : [];
  if (breaches.length === 0) return null;
  const { units } = scene.stage;
  const rest = breaches.length - MOST;
  return (
    <div class="note clash">
      <Icon node={TriangleAlert} />
      <div>
        <p>Nearer here than {lengthWithUnit(scene.minimumDistance, units)}:</p>
        <ul class="breaches" aria-label="Too near">
          {breaches.slice(0, MOST).map(({ a, b, distance }) => (
            <li key={`${a} ${b}`}>
              <button
                type="button"
                class="link"
                onClick={() => {
                  document.activeKeyframe.value = index;
                  document.selection.value = { kind: "agents", agents: new Set([a, b]) };
                }}
              >
                {agentLabel(scene, a)} and {agentLabel(scene, b)}
              </button>{" "}
              <span class="number">{lengthWithUnit(distance, units)}</span>
            </li>
          ))}
        </ul>
        {rest > 0 && <p>and {rest} more</p>}
      </div>
    </div>
  );
}
