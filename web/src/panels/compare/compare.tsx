import "../dialogs/dialogs.css";
import "./compare.css";
import { useState } from "preact/hooks";
import { keyframeLabel } from "../../document/queries";
import { mainTrack } from "../../document/scene";
import { endsAround } from "../../document/stretches";
import { Segmented } from "../controls/segmented";
import type { Comparison } from "../dialogs/dialogs";
import { Frame } from "../dialogs/frame";
import type { DialogProps } from "../dialogs/host";
import { lazily } from "../lazily";
import { useStudio } from "../studio";
import { Sides } from "./side-by-side";
import { startingSides, transitionAtHand } from "./starting-sides";

const RunView = lazily(() => import("./run/run-view").then((part) => part.RunView));

type View = "sides" | "run";

const VIEWS: readonly { readonly value: View; readonly label: string }[] = [
  { value: "sides", label: "Side by side" },
  { value: "run", label: "Table and plots" },
];

/** Two ways from one formation to the next, side by side and in step, with the numbers of both; or many ways as a table and over time. */
export function CompareDialog({ request, dialogs }: DialogProps<Comparison>) {
  const { document, playback } = useStudio();
  const [sides] = useState(() => {
    const scene = document.scene.peek();
    const hand = transitionAtHand(scene, document.selection.peek(), playback.time.peek());
    playback.pause();
    return startingSides(scene, request.segments ?? [hand, hand]);
  });
  const [view, setView] = useState<View>(request.isTable ? "run" : "sides");
  const scene = document.scene.value;
  const index = sides?.[0]?.segment ?? 0;
  const [from, to] = endsAround(mainTrack(scene), index);
  const without = to - from > 1 ? ", without its in-betweens" : "";
  return (
    <Frame
      title="Compare methods"
      size="whole"
      lead={mainTrack(scene).segments[index] && `${keyframeLabel(scene, from)} → ${keyframeLabel(scene, to)}${without}`}
      onClose={dialogs.close}
    >
      {sides ? (
        <>
          <div class="compare-view">
            <Segmented label="View" value={view} choices={VIEWS} onChoose={(chosen) => setView(chosen)} />
          </div>
          {view === "sides" ? (
            <Sides first={sides} preset={request.preset} onDone={dialogs.close} />
          ) : (
            <RunView segment={index} preset={request.table} />
          )}
        </>
      ) : (
        <p class="dialog-text">There is no transition to compare yet. Add a second keyframe first.</p>
      )}
    </Frame>
  );
}
