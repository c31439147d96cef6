import { useSignalEffect } from "@preact/signals";
import { useRef } from "preact/hooks";
import { selectedAgents } from "../../document/queries";
import { mainTrack } from "../../document/scene";
import { selectionBounds, selectionBox } from "../../stage/handles";
import { discRadius, screenSpacing, spacingAt } from "../../stage/spacing";
import { showOf } from "../show-of";
import { useStudio } from "../studio";
import { placeBar } from "./bar-place";
import { ContextActions } from "./context-actions";

/** The bar of actions beside the selection, which follows it as the view moves. */
export function SelectionBar({ agents }: { agents: ReadonlySet<number> }) {
  const { seen, playback, view } = useStudio();
  const { document } = seen;
  const bar = useRef<HTMLDivElement>(null);

  useSignalEffect(() => {
    const show = showOf(seen).value;
    const xy = new Float32Array(show.agentCount * 2);
    const camera = view.camera.value;
    const size = view.size.value;
    const covered = view.covered.value;
    show.positionsInto(playback.time.value, xy);
    const spacing = spacingAt(mainTrack(document.scene.value), playback.time.value);
    const bounds = selectionBounds(xy, selectedAgents(document.scene.value, document.selection.value));
    const element = bar.current;
    if (!element || !bounds) return;
    const box = selectionBox(bounds, camera, discRadius(screenSpacing(spacing, camera.scale)));
    const place = placeBar(box, { width: element.offsetWidth, height: element.offsetHeight }, size, covered);
    element.style.transform = `translate(${place.left}px, ${place.top}px)`;
  });

  return (
    <div ref={bar} class="floating context-bar" role="toolbar" aria-label="Selection">
      <ContextActions agents={agents} />
    </div>
  );
}
