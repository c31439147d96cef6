import { type Signal, signal } from "@preact/signals";
import { useEffect, useState } from "preact/hooks";
import type { Scene } from "../../document/scene";
import type { Planner } from "../../engine/api";
import { createPlanner } from "../../engine/create-planner";
import { useSolo } from "../use-solo";
import type { Trial } from "./sides";

/** A trial with an engine of its own that plans it. */
export interface PlannedTrial {
  readonly scene: Signal<Scene>;
  readonly planner: Planner;
}

/** Plans `trial`, and plans anew when it is another; ends with the view. */
export function useTrial(trial: Trial, time: Signal<number>): PlannedTrial {
  const solo = useSolo();
  const [planned] = useState(() => {
    const scene = signal(trial.scene);
    // What it watches is known to nobody else: it goes when the view does.
    return { scene, planner: createPlanner({ scene, isDragging: signal(false), time, crew: solo }) };
  });
  useEffect(() => {
    planned.scene.value = trial.scene;
  }, [planned, trial.scene]);
  return planned;
}
