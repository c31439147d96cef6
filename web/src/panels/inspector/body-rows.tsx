import { setRadius, setTopSpeed } from "../../document/commands/agents";
import { LIMITS } from "../../document/limits";
import { mainTrack } from "../../document/scene";
import { formatNumber, metersPer } from "../../document/units";
import { NumberBox } from "../controls/number-box";
import { Row } from "../controls/row";
import { Switch } from "../controls/switch";
import { useStudio } from "../studio";
import { isLongUnit, lengthQuantity } from "./quantities";

/** What a limit starts with, m/s: faster than a brisk walk, slower than a run. */
const FIRST_LIMIT = 2;

/** How large agents are and how fast they can be: what a crowd's forces heed. */
export function BodyRows({ agents }: { agents: ReadonlySet<number> }) {
  const { document } = useStudio();
  const scene = document.scene.value;
  const { units } = scene.stage;
  const per = metersPer(units);
  const isLong = isLongUnit(units);
  const bodies = mainTrack(scene).agents.filter((_, agent) => agents.has(agent));
  const radii = bodies.map(({ radius }) => radius / per);
  const limits = bodies.flatMap(({ maxSpeed }) => (maxSpeed === null ? [] : [maxSpeed / per]));
  const speedUnit = `${units}/s`;
  const { min, max } = LIMITS.maxSpeed;
  const size = lengthQuantity(units, { min: 0, max: LIMITS.length / per, step: 0.05 });
  const speed = lengthQuantity(units, { min: min / per, max: max / per, step: 0.1 });
  const setLimit = (limit: number | null) => document.perform(setTopSpeed(agents, limit));
  return (
    <>
      <Row label="Radius" note={noteOf(radii, isLong ? units : "") || "in a crowd"}>
        <NumberBox
          label="Radius"
          value={Math.max(...radii)}
          quantity={size}
          isUnitBeside={isLong}
          onCommit={(radius) => document.perform(setRadius(agents, radius * per))}
        />
      </Row>
      <Switch
        label="Limit speed"
        note={limits.length > 0 && limits.length < bodies.length ? "of some of them" : "in a crowd"}
        isOn={limits.length > 0}
        onToggle={(isOn) => setLimit(isOn ? FIRST_LIMIT : null)}
      />
      {limits.length > 0 && (
        <Row label="Top speed" note={noteOf(limits, isLong ? speedUnit : "")}>
          <NumberBox
            label="Top speed"
            value={Math.max(...limits)}
            quantity={{ ...speed, unit: speedUnit }}
            isUnitBeside={isLong}
            onCommit={(limit) => setLimit(limit * per)}
          />
        </Row>
      )}
    </>
  );
}

/** What one number cannot say of several, and the unit that its box has no room for. */
function noteOf(values: readonly number[], unit: string): string {
  const [least, most] = [Math.min(...values), Math.max(...values)].map((value) => formatNumber(value));
  return [least === most ? "" : `${least} to ${most}`, unit].filter(Boolean).join(", ");
}
