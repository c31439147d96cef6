import { useComputed } from "@preact/signals";
import { selectedAgents } from "../../document/queries";
import { lazily } from "../lazily";
import { useStudio } from "../studio";

const SelectionBar = lazily(() => import("./selection-bar").then((part) => part.SelectionBar));

/** What can be done with the selected agents, beside them; away while they move. */
export function ContextBar() {
  const { document, playback, toolbox } = useStudio();
  const agents = useComputed(() => selectedAgents(document.scene.value, document.selection.value));
  const isShown = useComputed(
    () =>
      agents.value.size > 1 &&
      document.selection.value.kind !== "tie" &&
      !playback.isPlaying.value &&
      !document.isDragging.value &&
      (toolbox.active.value === "select" || toolbox.active.value === "group"),
  );
  return isShown.value ? <SelectionBar agents={agents.value} /> : null;
}
