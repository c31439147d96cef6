import { boxOf, centerOf } from "../../document/box";
import { moveAgents, setPlace } from "../../document/commands/agents";
import type { Point } from "../../document/formation";
import { keyframeLabel } from "../../document/queries";
import { mainTrack } from "../../document/scene";
import { Row } from "../controls/row";
import { useStudio } from "../studio";
import { PlaceBoxes } from "./place-boxes";
import { isLongUnit } from "./quantities";

/** Where agents stand at the keyframe being edited; the middle of their box when they are several. */
export function PositionRow({ agents, label }: { agents: ReadonlySet<number>; label: string }) {
  const { document } = useStudio();
  const scene = document.scene.value;
  const keyframe = document.activeKeyframe.value;
  const positions = mainTrack(scene).keyframes[keyframe]?.positions;
  const box = positions ? boxOf(positions, agents) : null;
  if (!box) return null;
  const [x, y] = centerOf(box);
  const { units } = scene.stage;

  function move(to: Point): void {
    const [only] = agents;
    const isOne = agents.size === 1 && only !== undefined;
    document.perform(
      // One agent is put, not moved: adding a difference would leave it beside what was typed by round-off.
      isOne ? setPlace(keyframe, only, to) : moveAgents(keyframe, agents, [to[0] - x, to[1] - y]),
    );
  }

  const where = `at ${keyframeLabel(scene, keyframe)}`;
  return (
    <Row label={label} note={isLongUnit(units) ? `${units}, ${where}` : where}>
      <PlaceBoxes at={[x, y]} units={units} onCommit={move} />
    </Row>
  );
}
