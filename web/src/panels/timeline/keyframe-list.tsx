import { useRef } from "preact/hooks";
import { reorderKeyframe } from "../../document/commands/keyframes";
import { mainTrack } from "../../document/scene";
import { useStudio } from "../studio";
import { KeyframeDrag } from "./keyframe-drag";
import { KeyframeOption } from "./keyframe-option";
import { keyframePlaces } from "./layout";
import { THUMBNAIL_WIDTH, xOf } from "./scale";
import { useAgentColors, usePalette } from "./use-paint";
import type { Viewport } from "./viewport";

/** The formations of the show at their times. Arrows walk, a drag retimes, a drag onto another takes its place. */
export function KeyframeList({ viewport }: { viewport: Viewport }) {
  const { document, playback, messages } = useStudio();
  const list = useRef<HTMLDivElement>(null);
  const drag = useRef<KeyframeDrag>(null);
  drag.current ??= new KeyframeDrag(document, () => viewport.scale.peek());
  const dragging = drag.current;

  const { keyframes } = mainTrack(document.scene.value);
  const places = keyframePlaces(keyframes, viewport.scale.value);
  const { from, to } = viewport.drawn.value;
  const selection = document.selection.value;
  const state = dragging.state.value;
  const paint = { colors: useAgentColors().value, palette: usePalette() };
  const active = Math.min(document.activeKeyframe.value, keyframes.length - 1);

  const choose = (index: number) => {
    const keyframe = mainTrack(document.scene.peek()).keyframes[index];
    if (!keyframe) return;
    document.selection.value = { kind: "keyframe", index };
    document.activeKeyframe.value = index;
    playback.seek(keyframe.time);
    viewport.reveal(keyframe.time);
    option(list.current, index)?.focus({ preventScroll: true });
  };

  const reorder = (index: number, other: number) => {
    if (other < 0 || other >= keyframes.length) return;
    document.perform(reorderKeyframe(index, other));
    choose(other);
    messages.announce(`Moved to place ${other + 1} of ${keyframes.length}`);
  };

  return (
    <div
      ref={list}
      class="keyframes"
      role="listbox"
      aria-label="Keyframes"
      aria-orientation="horizontal"
      onKeyDown={(event) => {
        const index = indexOf(event.target);
        if (index === null) return;
        if (event.key === "Escape" && state.kind !== "idle") dragging.cancel();
        else if (event.altKey && event.key === "ArrowLeft") reorder(index, index - 1);
        else if (event.altKey && event.key === "ArrowRight") reorder(index, index + 1);
        else if (event.key === "ArrowLeft") choose(Math.max(0, index - 1));
        else if (event.key === "ArrowRight") choose(Math.min(keyframes.length - 1, index + 1));
        else if (event.key === "Home") choose(0);
        else if (event.key === "End") choose(keyframes.length - 1);
        else if (event.key === "Enter") choose(index);
        else return;
        event.preventDefault();
        event.stopPropagation();
      }}
    >
      {keyframes.map((keyframe, index) => {
        const place = places[index] ?? { x: xOf(viewport.scale.value, keyframe.time), right: 0 };
        return (
          <KeyframeOption
            key={index}
            index={index}
            keyframe={keyframe}
            place={place}
            isSelected={selection.kind === "keyframe" && selection.index === index}
            isFocusable={index === active}
            paint={place.x + THUMBNAIL_WIDTH > from && place.x - THUMBNAIL_WIDTH < to ? paint : null}
            mark={
              state.kind === "reordering" && state.other === index
                ? "target"
                : (state.kind === "retiming" || state.kind === "reordering") && state.index === index
                  ? "dragged"
                  : "none"
            }
            handlers={{
              onPointerDown(event) {
                if (event.button !== 0 || !event.isPrimary) return;
                event.currentTarget.setPointerCapture(event.pointerId);
                dragging.press(index, event.clientX + viewport.scroll.peek());
              },
              onPointerMove(event) {
                dragging.move({
                  x: event.clientX + viewport.scroll.peek(),
                  isRipple: event.altKey,
                  playhead: playback.time.peek(),
                });
              },
              onPointerUp() {
                if (dragging.release()) choose(index);
              },
              onPointerCancel() {
                dragging.cancel();
              },
            }}
          />
        );
      })}
    </div>
  );
}

function option(list: HTMLElement | null, index: number): HTMLElement | null {
  return list?.querySelector<HTMLElement>(`[data-index="${index}"]`) ?? null;
}

function indexOf(target: EventTarget | null): number | null {
  const index = target instanceof HTMLElement ? target.dataset.index : undefined;
  return index === undefined ? null : Number(index);
}
