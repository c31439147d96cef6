import { signal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { NOTHING } from "../../document/selection";
import type { Playback } from "../../playback/playback";
import { createStage } from "../../stage/stage";
import type { View } from "../../stage/view";
import { attachTools } from "../../tools/attach-tools";
import type { Overlay, ToolName } from "../../tools/toolbox";
import type { PlannedTrial } from "./use-trial";

/** A stage to look at: it is panned and zoomed, and nothing on it is changed. */
export function SideStage({ trial, playback, view }: { trial: PlannedTrial; playback: Playback; view: View }) {
  const host = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const element = host.current;
    if (!element) return;
    const toolbox = handsOff();
    const stage = createStage(element, {
      scene: trial.scene,
      isSettled: signal(true),
      selection: signal(NOTHING),
      segments: trial.planner.segments,
      ties: trial.planner.ties,
      playback,
      view,
      toolbox,
    });
    const detach = attachTools(element, toolbox, view, false);
    return () => {
      detach();
      stage.dispose();
    };
  }, [trial, playback, view]);
  return <div ref={host} class="compare-stage" />;
}

/** Space counts as held, so that every press pans. */
function handsOff() {
  return {
    active: signal<ToolName>("pan"),
    overlay: signal<Overlay>({ kind: "none" }),
    cursor: signal("grab"),
    isSpaceHeld: signal(true),
    notePan() {},
    send() {},
  };
}
