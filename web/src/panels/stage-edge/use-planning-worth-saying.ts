import { type ReadonlySignal, useComputed, useSignal, useSignalEffect } from "@preact/signals";
import { useStudio } from "../studio";

/** Shorter work is not worth a word; milliseconds. */
const WORTH_SAYING = 300;

/** Whether the engine has been planning for so long that the person should know. */
export function usePlanningWorthSaying(): ReadonlySignal<boolean> {
  const { planner } = useStudio();
  const isWorking = useComputed(() => planner.progress.value !== null);
  const isShown = useSignal(false);
  useSignalEffect(() => {
    if (!isWorking.value) {
      isShown.value = false;
      return;
    }
    const timer = setTimeout(() => {
      isShown.value = true;
    }, WORTH_SAYING);
    return () => clearTimeout(timer);
  });
  return isShown;
}
