import { obstacleLabel } from "../../document/obstacle";
import { agentLabel } from "../../document/queries";
import {
  formatAngle,
  formatDuration,
  formatLength,
  formatNumber,
  formatTime,
  lengthWithUnit,
} from "../../document/units";
import type { SegmentPlan } from "../../engine/api";
import { lazily } from "../lazily";
import { useStudio } from "../studio";
import { Measure } from "./measure";
import { Plot } from "./plot";
import { Section } from "./section";

/** A tenth of every tie's length, and five degrees: less than this lies low in its plot. */
const LITTLE_DISTORTION = 0.1;
const LITTLE_TURNING = (5 * Math.PI) / 180;

const MovementMeasures = lazily(() => import("./movement-measures").then((part) => part.MovementMeasures));

interface MeasuresProps {
  readonly plan: SegmentPlan;
  readonly index: number;
  /** Of a motion that another is planned in place of. */
  readonly isFormer: boolean;
}

/** How well a transition keeps the group together: over time, and in its worst moment. */
export function Measures({ plan, index, isFormer }: MeasuresProps) {
  const { document } = useStudio();
  const scene = document.scene.value;
  const { units } = scene.stage;
  const { report, curves } = plan;
  const { start, end } = plan.motion;
  const span = { from: start, to: end };
  const clearance = report.clearance;
  const speed = report.topSpeed;
  const held = report.heldClearance;
  return (
    <Section
      title="Measures"
      note={isFormer ? "of the motion before" : `over ${formatDuration(end - start)}`}
      isRegion
      isFormer={isFormer}
    >
      {clearance && (
        <Measure
          label="Clearance"
          plot={<Plot values={curves.clearance} {...span} limit={scene.minimumDistance} />}
          value={formatLength(clearance.distance, units)}
          unit={units}
          worst={
            report.guideClearance
              ? `before ${lengthWithUnit(report.guideClearance.distance, units)}`
              : `at ${formatTime(clearance.time)}`
          }
        />
      )}
      {held && (
        <Measure
          label="Held clearance"
          plot={null}
          value={formatLength(held.distance, units)}
          unit={units}
          worst={`${agentLabel(scene, held.agent)} to ${obstacleLabel(scene, held.obstacle)}`}
        />
      )}
      {report.deviation && (
        <Measure
          label="Deviation"
          plot={null}
          value={formatLength(report.deviation.mean, units)}
          unit={units}
          worst={`max ${formatLength(report.deviation.max, units)}`}
        />
      )}
      <Measure
        label="Distortion"
        plot={<Plot values={curves.distortion} {...span} least={LITTLE_DISTORTION} />}
        value={formatNumber(report.distortion.mean)}
        worst={`max ${formatNumber(report.distortion.max)}`}
      />
      <Measure
        label="Turning"
        plot={<Plot values={curves.turning} {...span} least={LITTLE_TURNING} />}
        value={formatAngle(report.turning.mean)}
        worst={`max ${formatAngle(report.turning.max)}`}
      />
      <Measure
        label="Path length"
        plot={<Plot values={curves.pathLength} {...span} />}
        value={formatLength(report.pathLength.mean, units, 1)}
        unit={units}
        worst={`max ${formatLength(report.pathLength.max, units, 1)}`}
      />
      <Measure
        label="Top speed"
        plot={<Plot values={curves.topSpeed} {...span} />}
        value={formatLength(speed.speed, units, 1)}
        unit={`${units}/s`}
        worst={`agent ${agentLabel(scene, speed.agent)}`}
      />
      <MovementMeasures index={index} />
    </Section>
  );
}
