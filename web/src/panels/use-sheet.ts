import { type Signal, useSignal, useSignalEffect } from "@preact/signals";
import { useStudio } from "./studio";
import { penOn } from "./travel/pen";

/**
 * On a narrow screen the inspector is a sheet over the stage, which opens for what has nothing else to show and makes way
 * for the pen of a path.
 */
export function useSheet(): Signal<boolean> {
  const { document } = useStudio();
  const isOpen = useSignal(false);
  useSignalEffect(() => {
    const { kind } = document.selection.value;
    if (kind === "transition" || kind === "tie") isOpen.value = true;
    if (kind === "none") isOpen.value = false;
  });
  useSignalEffect(() => {
    if (penOn.value !== null) isOpen.value = false;
  });
  return isOpen;
}
