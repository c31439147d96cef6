import { type Signal, signal } from "@preact/signals";
import { useEffect, useMemo, useState } from "preact/hooks";
import type { Scene } from "../../document/scene";
import type { Planner } from "../../engine/api";
import { createPlanner } from "../../engine/create-planner";
import { useStudio } from "../studio";
import { useSolo } from "../use-solo";
import { type Side, type Trial, trialOf } from "./sides";

/** A trial with an engine of its own that plans it. */
export interface PlannedTrial {
  readonly scene: Signal<Scene>;
  readonly planner: Planner;
  /** Which of the planned transitions it is. */
  readonly segment: number;
}

/** Plans a side that leaves at `start`, and plans anew when it is another, with one counterpart; ends with the view. */
export function useTrial(side: Side, start: number, time: Signal<number>): PlannedTrial {
  const whole = useStudio().document.scene.value;
  const solo = useSolo();
  const { counterpart } = side;
  const trial = useMemo((): Trial => trialOf(whole, side, start), [whole, side, start]);
  const [planned] = useState(() => {
    const scene = signal(trial.scene);
    // What it watches is known to nobody else: it goes when the view does.
    return { scene, planner: createPlanner({ scene, isDragging: signal(false), time, crew: solo, counterpart }) };
  });
  useEffect(() => {
    planned.scene.value = trial.scene;
  }, [planned, trial.scene]);
  return useMemo(() => ({ ...planned, segment: trial.segment }), [planned, trial.segment]);
}
