import { liftAgents, setHeight } from "../../document/commands/heights";
import { mainTrack } from "../../document/scene";
import { metersPer } from "../../document/units";
import { NumberBox } from "../controls/number-box";
import { Row } from "../controls/row";
import { useStudio } from "../studio";
import { coordinateQuantity, isLongUnit } from "./quantities";

/** How high agents are at the keyframe being edited; the middle of lowest and highest when they are several. */
export function HeightRow({ agents }: { agents: ReadonlySet<number> }) {
  const { document } = useStudio();
  const scene = document.scene.value;
  const keyframe = document.activeKeyframe.value;
  const positions = mainTrack(scene).keyframes[keyframe]?.positions;
  if (!positions || agents.size === 0) return null;
  const heights = [...agents].map((agent) => positions.height(agent));
  const middle = (Math.min(...heights) + Math.max(...heights)) / 2;
  const { units } = scene.stage;
  const per = metersPer(units);

  function lift(to: number): void {
    const [only] = agents;
    const isOne = agents.size === 1 && only !== undefined;
    document.perform(isOne ? setHeight(keyframe, only, to) : liftAgents(keyframe, agents, to - middle));
  }

  return (
    <Row label="Height">
      <NumberBox
        label="z"
        prefix="z"
        value={middle / per}
        quantity={coordinateQuantity(units)}
        isUnitBeside={isLongUnit(units)}
        onCommit={(value) => lift(value * per)}
      />
    </Row>
  );
}
