import { useRef } from "preact/hooks";
import { setHold } from "../../document/commands/retime";
import { keyframeLabel } from "../../document/queries";
import { mainTrack } from "../../document/scene";
import type { Gesture } from "../../document/store";
import { useStudio } from "../studio";
import { keyframePlaces } from "./layout";
import { placed } from "./place";
import { snapTime } from "./snap";
import type { Viewport } from "./viewport";

const KEY_STEP = 0.5;

/** Pulls the selected keyframe's right edge on: how long the agents stand in it. */
export function HoldHandle({ viewport }: { viewport: Viewport }) {
  const { document, playback, view } = useStudio();
  const drag = useRef<{ readonly gesture: Gesture; readonly x: number; readonly hold: number } | null>(null);
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
  };

  return (
    <div
      ref={placed(place.right)}
      class="hold-handle"
      role="slider"
      tabIndex={0}
      aria-label={`Hold of ${keyframeLabel(scene, index)}`}
      aria-valuemin={0}
      aria-valuemax={keyframes[index + 1] ? (keyframes[index + 1]?.time ?? 0) - keyframe.time : 3600}
      aria-valuenow={keyframe.hold}
      aria-valuetext={`${Math.round(keyframe.hold * 100) / 100} s`}
      data-tip="Hold"
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
        from.gesture.preview(setHold(index, snapped - keyframe.time));
      }}
      onPointerUp={() => end("commit")}
      onPointerCancel={() => end("cancel")}
      onKeyDown={(event) => {
        if (event.key === "Escape" && drag.current) end("cancel");
        else if (event.key === "ArrowRight") document.perform(setHold(index, keyframe.hold + KEY_STEP));
        else if (event.key === "ArrowLeft") document.perform(setHold(index, Math.max(0, keyframe.hold - KEY_STEP)));
        else if (event.key === "Home" || event.key === "Delete") document.perform(setHold(index, 0));
        else return;
        event.preventDefault();
        event.stopPropagation();
      }}
    />
  );
}
