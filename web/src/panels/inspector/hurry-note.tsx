import { TriangleAlert } from "lucide";
import { rippleKeyframe } from "../../document/commands/retime";
import { LIMITS } from "../../document/limits";
import { agentLabel } from "../../document/queries";
import { mainTrack } from "../../document/scene";
import { formatDuration, lengthWithUnit } from "../../document/units";
import type { Hurry } from "../../engine/api";
import { Icon } from "../../theme/icons";
import { Few } from "../few";
import { useStudio } from "../studio";

/** More would push the measures out of sight. */
const MOST = 3;

/** Who is faster than they can be, because a keyframe has them where it has them; and the duration that would do. */
export function HurryNote({ index, hurried }: { index: number; hurried: readonly Hurry[] }) {
  const { document } = useStudio();
  const scene = document.scene.value;
  const from = mainTrack(scene).keyframes[index];
  const worst = [...hurried].sort((a, b) => b.duration - a.duration);
  const longest = worst[0]?.duration ?? 0;
  const speed = (metersPerSecond: number) => `${lengthWithUnit(metersPerSecond, scene.stage.units)}/s`;
  return (
    <div class="note clash">
      <Icon node={TriangleAlert} />
      <div>
        <Few all={worst} most={MOST}>
          {({ agent, speed: needed, maxSpeed }) => (
            <p key={agent}>
              Agent {agentLabel(scene, agent)} moves at up to {speed(needed)} to arrive in time; its top speed is{" "}
              {speed(maxSpeed)}.
            </p>
          )}
        </Few>
        {from && longest <= LIMITS.seconds && (
          <fieldset class="next-steps" aria-label="What may help">
            <button
              type="button"
              class="button"
              onClick={() => document.perform(rippleKeyframe(index + 1, from.time + from.hold + longest))}
            >
              Take {formatDuration(longest)}
            </button>
          </fieldset>
        )}
      </div>
    </div>
  );
}
