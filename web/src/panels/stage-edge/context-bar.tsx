import { useComputed, useSignalEffect } from "@preact/signals";
import { useRef } from "preact/hooks";
import { selectedAgents } from "../../document/queries";
import { mainTrack } from "../../document/scene";
import { selectionBounds, selectionBox } from "../../stage/handles";
import { discRadius, screenSpacing, spacingAt } from "../../stage/spacing";
import { showOf } from "../show-of";
import { useStudio } from "../studio";
import { placeBar } from "./bar-place";
import { ContextActions } from "./context-actions";

/** What can be done with the selected agents, beside them; away while they move. */
export function ContextBar() {
  const studio = useStudio();
  const { document, playback, toolbox } = studio;
  const agents = useComputed(() => selectedAgents(document.scene.value, document.selection.value));
  const isShown = useComputed(
    () =>
      agents.value.size > 1 &&
      document.selection.value.kind !== "tie" &&
      !playback.isPlaying.value &&
      !document.isDragging.value &&
      (toolbox.active.value === "select" || toolbox.active.value === "group"),
  );
  return isShown.value ? <Bar agents={agents.value} /> : null;
}

function Bar({ agents }: { agents: ReadonlySet<number> }) {
  const studio = useStudio();
  const { document, playback, view } = studio;
  const bar = useRef<HTMLDivElement>(null);

  useSignalEffect(() => {
    const show = showOf(studio).value;
    const xy = new Float32Array(show.agentCount * 2);
    const camera = view.camera.value;
    const size = view.size.value;
    show.positionsInto(playback.time.value, xy);
    const spacing = spacingAt(mainTrack(document.scene.value), playback.time.value);
    const bounds = selectionBounds(xy, selectedAgents(document.scene.value, document.selection.value));
    const element = bar.current;
    if (!element || !bounds) return;
    const box = selectionBox(bounds, camera, discRadius(screenSpacing(spacing, camera.scale)));
    const place = placeBar(box, { width: element.offsetWidth, height: element.offsetHeight }, size);
    element.style.transform = `translate(${place.left}px, ${place.top}px)`;
  });

  return (
    <div ref={bar} class="floating context-bar" role="toolbar" aria-label="Selection">
      <ContextActions agents={agents} />
    </div>
  );
}
