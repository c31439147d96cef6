import { TriangleAlert } from "lucide";
import type { Formation } from "../../document/formation";
import { distanceTo, obstacleLabel } from "../../document/obstacle";
import { agentLabel } from "../../document/queries";
import { mainTrack, type Scene } from "../../document/scene";
import { lengthWithUnit } from "../../document/units";
import { Icon } from "../../theme/icons";
import { breachesOf } from "../breaches";
import { AndMore, fewOf } from "../few";
import { useStudio } from "../studio";

/** A distance that is kept may fall short by this share of it: coordinates are rounded in links and by conversions. */
const ROUNDING = 1e-4;

/** More would push the panel's own rows out of sight. */
const MOST = 5;

/** Who stands too near in a keyframe. Nobody moves them: a keyframe is the person's. */
export function BreachNote({ index }: { index: number }) {
  const { document } = useStudio();
  const scene = document.scene.value;
  const formation = mainTrack(scene).keyframes[index]?.positions;
  if (!formation) return null;
  const { units } = scene.stage;
  const entries = [
    ...breachesOf(formation, scene.minimumDistance).map(({ a, b, distance }) => ({
      agents: [a, b],
      words: `${agentLabel(scene, a)} and ${agentLabel(scene, b)}`,
      where: lengthWithUnit(distance, units),
    })),
    ...tooNearObstacles(scene, formation),
  ];
  if (entries.length === 0) return null;
  const few = fewOf(entries, MOST);
  return (
    <div class="note clash">
      <Icon node={TriangleAlert} />
      <div>
        <p>Nearer here than {lengthWithUnit(scene.minimumDistance, units)}:</p>
        <ul class="breaches" aria-label="Too near">
          {few.map(({ agents, words, where }) => (
            <li key={words}>
              <button
                type="button"
                class="link"
                onClick={() => {
                  document.activeKeyframe.value = index;
                  document.selection.value = { kind: "agents", agents: new Set(agents) };
                }}
              >
                {words}
              </button>{" "}
              <span class="number">{where}</span>
            </li>
          ))}
        </ul>
        <AndMore count={entries.length - few.length} />
      </div>
    </div>
  );
}

/** Who stands nearer to an obstacle than they may, or in it. */
function tooNearObstacles(scene: Scene, formation: Formation) {
  return scene.obstacles.flatMap(({ shape }, obstacle) =>
    formation.points().flatMap((at, agent) => {
      const distance = distanceTo(shape, at);
      if (distance >= scene.minimumDistance * (1 - ROUNDING)) return [];
      const where = distance > 0 ? lengthWithUnit(distance, scene.stage.units) : "inside";
      return [{ agents: [agent], words: `${agentLabel(scene, agent)} and ${obstacleLabel(scene, obstacle)}`, where }];
    }),
  );
}
