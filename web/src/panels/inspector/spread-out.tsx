import "./spread-out.css";
import { useSignalEffect } from "@preact/signals";
import { useEffect, useRef, useState } from "preact/hooks";
import { agentLabel } from "../../document/queries";
import { mainTrack } from "../../document/scene";
import { formatTime, lengthWithUnit } from "../../document/units";
import type { SegmentReport } from "../../engine/api";
import { askSalvage, type SalvageReport } from "../../engine/salvage";
import { createSolo } from "../../engine/solo";
import { useStudio } from "../studio";
import { spreadRows } from "./spread-rows";
import { createSpreading, type Spreading } from "./spreading";

/** Lets those who are stuck spread out: looked for on request, shown on the stage, kept only when it is accepted. */
export function SpreadOut({ index, report }: { index: number; report: SegmentReport | null }) {
  const { document, messages } = useStudio();
  const before = useRef(report);
  const [spreading] = useState(() =>
    createSpreading({
      document,
      index,
      search(scene, onProgress) {
        const solo = createSolo();
        const found = askSalvage(solo, scene, index, onProgress);
        return { found, end: solo.end };
      },
      announce: messages.announce,
      onProblem(error) {
        const text = error instanceof Error ? error.message : String(error);
        messages.say({ tone: "problem", title: "They could not be spread out.", text });
      },
    }),
  );
  // What is looked for, or was not found, is of the motion as it was.
  useEffect(() => {
    if (spreading.state.peek().kind !== "shown") spreading.discard();
  }, [spreading, report]);
  // What nobody accepted is gone with the panel.
  useEffect(() => spreading.discard, [spreading]);
  useSignalEffect(() => {
    // Somebody edits what is shown: that takes it over.
    if (spreading.state.value.kind === "shown" && !document.isDragging.value) spreading.accept();
  });

  const state = spreading.state.value;
  const canStart = (report?.unsolved?.length ?? 0) > 0 && report?.breaches?.length === 0;
  if (state.kind === "idle" && !canStart) return null;
  if (state.kind === "shown") {
    return <Shown index={index} spreading={spreading} before={before.current} after={state.salvage.report} />;
  }
  before.current = report;
  if (state.kind === "helpless") return <Helpless report={state.salvage?.report ?? null} />;
  return (
    <div class="inspector-buttons">
      {state.kind === "searching" ? (
        <>
          <button type="button" class="button" onClick={spreading.discard}>
            Cancel
          </button>
          <span class="spread-progress number" role="status">
            Looking for room, {Math.floor(state.progress * 100)} %
          </span>
        </>
      ) : (
        <button type="button" class="button" onClick={spreading.start}>
          Let them spread out
        </button>
      )}
    </div>
  );
}

function Helpless({ report }: { report: SalvageReport | null }) {
  const scene = useStudio().document.scene.value;
  const worst = [...(report?.unsolved ?? [])].sort((a, b) => a.distance - b.distance)[0];
  return (
    <p class="inspector-text spread-words" role="status">
      Spreading out does not keep them apart
      {worst &&
        `: agents ${agentLabel(scene, worst.agents[0])} and ${agentLabel(scene, worst.agents[1])} still come within ${lengthWithUnit(worst.distance, scene.stage.units)} at ${formatTime(worst.time)}`}
      .
    </p>
  );
}

/** The motion that was found plays on the stage; its numbers beside those of the one before. */
function Shown(props: { index: number; spreading: Spreading; before: SegmentReport | null; after: SalvageReport }) {
  const { document, planner, playback } = useStudio();
  const { index, spreading, before, after } = props;
  const scene = document.scene.value;
  const play = () => {
    const from = mainTrack(document.scene.peek()).keyframes[index];
    playback.seek(from ? from.time + from.hold : 0);
    playback.play();
  };
  const hasPlayed = useRef(false);
  useSignalEffect(() => {
    if (planner.progress.value !== null || hasPlayed.current) return;
    hasPlayed.current = true;
    play();
  });
  useEffect(() => {
    function onKeyDown(event: KeyboardEvent): void {
      if (event.key !== "Escape" || event.defaultPrevented) return;
      // A dialog over it, such as Share, is closed first.
      if (event.target instanceof Element && event.target.closest("dialog")) return;
      event.preventDefault();
      spreading.discard();
    }
    addEventListener("keydown", onKeyDown, true);
    return () => removeEventListener("keydown", onKeyDown, true);
  }, [spreading]);
  return (
    <fieldset class="note spread" aria-label="Spread out">
      <table class="spread-table number">
        <thead>
          <tr>
            <td />
            <th scope="col">Before</th>
            <th scope="col">Spread out</th>
          </tr>
        </thead>
        <tbody>
          {spreadRows(before, after, scene.stage.units).map(({ label, was, now }) => (
            <tr key={label}>
              <th scope="row">{label}</th>
              <td>{was}</td>
              <td>{now}</td>
            </tr>
          ))}
        </tbody>
      </table>
      {after.isWild && <p class="spread-words">Far from what the transition was: better another step.</p>}
      <div class="inspector-buttons">
        <button type="button" class={after.isWild ? "button" : "button primary"} onClick={spreading.accept}>
          {after.isWild ? "Accept anyway" : "Accept"}
        </button>
        <button type="button" class={after.isWild ? "button primary" : "button"} onClick={spreading.discard}>
          Discard
        </button>
        <button type="button" class="button quiet" onClick={play}>
          Play again
        </button>
      </div>
    </fieldset>
  );
}
