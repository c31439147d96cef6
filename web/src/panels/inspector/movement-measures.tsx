import "./more-rows.css";
import { useEffect, useState } from "preact/hooks";
import type { Scene, Units } from "../../document/scene";
import { formatLength, formatNumber, lengthWithUnit } from "../../document/units";
import { EngineError, type Extreme } from "../../engine/api";
import { askMovement, type Movement } from "../../engine/movement";
import { useStudio } from "../studio";
import { useSolo } from "../use-solo";
import { Measure } from "./measure";
import { Plot } from "./plot";

/** Milliseconds after the last change; while the scene is dragged nothing is found. */
const PAUSE = 400;

type Curve = Exclude<keyof Movement["curves"], "times">;

const INFORMATION: readonly { curve: Curve; label: string }[] = [
  { curve: "mutualInformation", label: "Direction told" },
  { curve: "speedInformation", label: "Speed told" },
];

const DEVIATIONS: readonly { curve: Curve; label: string }[] = [
  { curve: "structureDeviation", label: "Structure σ" },
  { curve: "effortDeviation", label: "Effort σ" },
  { curve: "targetDeviation", label: "To the target" },
];

/** How a movement looks as a whole: found when it is opened, by an engine of its own. */
export function MovementMeasures({ index }: { index: number }) {
  const { document } = useStudio();
  const [isOpen, setOpen] = useState(false);
  return (
    <details class="more-rows" onToggle={(event) => setOpen(event.currentTarget.open)}>
      <summary>Movement as a whole</summary>
      {isOpen && <Numbers scene={document.scene.value} index={index} />}
    </details>
  );
}

function Numbers({ scene, index }: { scene: Scene; index: number }) {
  const { movement, problem } = useMovement(scene, index);
  if (problem) return <p class="inspector-text">{problem}</p>;
  if (!movement) return <p class="inspector-text">Measuring…</p>;
  const { measures, curves } = movement;
  const span = { from: curves.times[0] ?? 0, to: curves.times.at(-1) ?? 0 };
  const { units } = scene.stage;
  const rows = (list: typeof DEVIATIONS, read: (extreme: Extreme) => { value: string; unit: string; worst: string }) =>
    list.map(({ curve, label }) => (
      <Measure
        key={curve}
        label={label}
        plot={<Plot values={Float32Array.from(curves[curve])} {...span} />}
        {...read(measures[curve])}
      />
    ));
  return (
    <>
      {rows(INFORMATION, inBits)}
      {rows(DEVIATIONS, (extreme) => inLength(extreme, units))}
      <Measure label="Roughness" plot={null} value={formatNumber(measures.roughness)} unit="m/s³" worst="median jerk" />
    </>
  );
}

function inBits({ mean, max }: Extreme) {
  return { value: formatNumber(mean), unit: "bits", worst: `max ${formatNumber(max)}` };
}

function inLength({ mean, max }: Extreme, units: Units) {
  return { value: formatLength(mean, units), unit: units, worst: `max ${lengthWithUnit(max, units)}` };
}

/** Of the scene as it is after a pause; the last one stays meanwhile. */
function useMovement(scene: Scene, index: number) {
  const solo = useSolo();
  const [found, setFound] = useState<{ movement: Movement | null; problem: string }>({ movement: null, problem: "" });
  useEffect(() => {
    let isWanted = true;
    const timer = setTimeout(() => {
      askMovement(solo, scene, index).then(
        (movement) => isWanted && setFound({ movement, problem: "" }),
        (error: unknown) => {
          if (!(error instanceof EngineError)) throw error;
          if (isWanted) setFound({ movement: null, problem: error.message });
        },
      );
    }, PAUSE);
    return () => {
      isWanted = false;
      clearTimeout(timer);
    };
  }, [solo, scene, index]);
  return found;
}
