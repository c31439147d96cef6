import { useRef, useState } from "preact/hooks";
import { setHold } from "../../document/commands/retime";
import { keyframeLabel } from "../../document/queries";
import { mainTrack } from "../../document/scene";
import type { Command, Gesture } from "../../document/store";
import { useStudio } from "../studio";
import { keyframePlaces } from "./layout";
import { LimitNote } from "./limit-note";
import { placed } from "./place";
import { snapTime } from "./snap";
import type { Viewport } from "./viewport";

const KEY_STEP = 0.5;

/** Times are set to the millisecond, seconds. */
const ROUNDING = 1e-3;

/** Pulls the selected keyframe's right edge on: how long the agents stand in it. */
export function HoldHandle({ viewport }: { viewport: Viewport }) {
  const { document, playback, view } = useStudio();
  const drag = useRef<{ readonly gesture: Gesture; readonly x: number; readonly hold: number } | null>(null);
  const handle = useRef<HTMLDivElement | null>(null);
  /** The hold it was stopped at although it was pulled further. */
  const [stop, setStop] = useState<number | null>(null);
  const selection = document.selection.value;
  const scene = document.scene.value;
  const { keyframes } = mainTrack(scene);
  const index = selection.kind === "keyframe" ? selection.index : -1;
  const keyframe = keyframes[index];
  const place = keyframePlaces(keyframes, viewport.scale.value)[index];
  if (!keyframe || !place) return null;

  const end = (how: "commit" | "cancel") => {
    drag.current?.gesture[how]();
    drag.current = null;
    setStop(null);
  };

  const pull = (hold: number, perform: (command: Command) => void) => {
    perform(setHold(index, hold));
    const landed = mainTrack(document.scene.peek()).keyframes[index]?.hold ?? hold;
    setStop(Math.abs(landed - hold) > ROUNDING ? landed : null);
  };

  return (
    <div
      ref={(element) => {
        handle.current = element;
        placed(place.right)(element);
      }}
      class="hold-handle"
      role="slider"
      tabIndex={0}
      aria-label={`Hold of ${keyframeLabel(scene, index)}`}
      aria-valuemin={0}
      aria-valuemax={keyframes[index + 1] ? (keyframes[index + 1]?.time ?? 0) - keyframe.time : 3600}
      aria-valuenow={keyframe.hold}
      aria-valuetext={inSeconds(keyframe.hold)}
      data-tip={stop === null ? "Hold" : undefined}
      data-tip-side="top"
      onPointerDown={(event) => {
        event.stopPropagation();
        event.currentTarget.setPointerCapture(event.pointerId);
        drag.current = { gesture: document.beginGesture(), x: event.clientX, hold: keyframe.hold };
      }}
      onPointerMove={(event) => {
        const from = drag.current;
        if (!from) return;
        const { pixelsPerSecond } = viewport.scale.peek();
        const wanted = keyframe.time + from.hold + (event.clientX - from.x) / pixelsPerSecond;
        const times = [playback.time.peek(), keyframe.time];
        const snapped = snapTime(wanted, scene, { pixelsPerSecond, times, ruler: view.ruler.peek() });
        pull(snapped - keyframe.time, from.gesture.preview);
      }}
      onPointerUp={() => end("commit")}
      onPointerCancel={() => end("cancel")}
      onKeyDown={(event) => {
        if (event.key === "Escape" && drag.current) end("cancel");
        else if (event.key === "ArrowRight") pull(keyframe.hold + KEY_STEP, document.perform);
        else if (event.key === "ArrowLeft") pull(keyframe.hold - KEY_STEP, document.perform);
        else if (event.key === "Home" || event.key === "Delete") pull(0, document.perform);
        else return;
        event.preventDefault();
        event.stopPropagation();
      }}
      onBlur={() => setStop(null)}
    >
      {stop !== null && <LimitNote what="Hold" stop={inSeconds(stop)} anchor={handle.current} />}
    </div>
  );
}

function inSeconds(hold: number): string {
  return `${Math.round(hold * 100) / 100} s`;
}
