import { useEffect, useMemo } from "preact/hooks";
import type { Command, Gesture } from "../../document/store";
import { useStudio } from "../studio";

/** Changes of the scene from one control: previews make one gesture, which ends with the control at the latest. */
export function useGesture() {
  const { document } = useStudio();
  const control = useMemo(() => {
    let open: Gesture | null = null;
    return {
      preview(command: Command): void {
        open ??= document.beginGesture();
        open.preview(command);
      },
      commit(): void {
        open?.commit();
        open = null;
      },
      cancel(): void {
        open?.cancel();
        open = null;
      },
      perform(command: Command): void {
        this.commit();
        document.perform(command);
      },
    };
  }, [document]);
  useEffect(() => control.commit, [control]);
  return control;
}
