import { useRef, useState } from "preact/hooks";
import { keyframeLabel } from "../../document/queries";
import { mainTrack } from "../../document/scene";
import { lazily } from "../lazily";
import { useStudio } from "../studio";

import { KeyframeOption } from "./keyframe-option";
import { LaterDrag } from "./later-drag";
import { keyframePlaces } from "./layout";
import { THUMBNAIL_WIDTH, xOf } from "./scale";
import { useAgentColors, usePalette } from "./use-paint";
import type { Viewport } from "./viewport";

const KeyframeMenu = lazily(() => import("./keyframe-menu").then((part) => part.KeyframeMenu));

/** The formations of the show at their times. Arrows walk, a drag retimes, a drag onto another takes its place. */
export function KeyframeList({ viewport }: { viewport: Viewport }) {
  const { actions, document, playback, messages } = useStudio();
  const [menuAt, setMenuAt] = useState<number | null>(null);
  const list = useRef<HTMLDivElement | null>(null);
  const drag = useRef<LaterDrag>(null);
  drag.current ??= new LaterDrag(document, () => viewport.scale.peek());
  const dragging = drag.current;
  const isDragOver = useRef(false);

  const scene = document.scene.value;
  const { keyframes } = mainTrack(scene);
  const places = keyframePlaces(keyframes, viewport.scale.value);
  const { from, to } = viewport.drawn.value;
  const selection = document.selection.value;
  const state = dragging.state.value;
  const paint = { colors: useAgentColors().value, palette: usePalette() };
  const active = Math.min(document.activeKeyframe.value, keyframes.length - 1);

  const isSelected = (index: number) => selection.kind === "keyframe" && selection.index === index;

  const choose = (index: number) => {
    const keyframe = mainTrack(document.scene.peek()).keyframes[index];
    if (!keyframe) return;
    document.selection.value = { kind: "keyframe", index };
    document.activeKeyframe.value = index;
    playback.seek(keyframe.time);
    viewport.reveal(keyframe.time);
    option(list.current, index)?.focus({ preventScroll: true });
  };

  const reorder = async (index: number, other: number) => {
    if (other < 0 || other >= keyframes.length) return;
    const { reorderKeyframe } = await import("../../document/commands/keyframes");
    document.perform(reorderKeyframe(index, other));
    choose(other);
    messages.announce(`Moved to place ${other + 1} of ${keyframes.length}`);
  };

  const remove = (index: number) => {
    choose(index);
    if (keyframes.length > 1) actions.get("delete-keyframe").run();
    queueMicrotask(() => option(list.current, document.activeKeyframe.peek())?.focus());
  };

  const menuAnchor = menuAt === null ? null : option(list.current, menuAt);
  return (
    <>
      <div
        ref={(element) => {
          list.current = element;
          if (element) element.style.width = `${places.at(-1)?.right ?? 0}px`;
        }}
        class="keyframes"
        role="listbox"
        aria-label="Keyframes"
        aria-orientation="horizontal"
        onKeyDown={(event) => {
          const index = indexOf(event.target);
          if (index === null) return;
          if (event.key === "Escape" && state.kind !== "idle") dragging.cancel();
          else if (event.altKey && event.key === "ArrowLeft") void reorder(index, index - 1);
          else if (event.altKey && event.key === "ArrowRight") void reorder(index, index + 1);
          else if (event.key === "ArrowLeft") choose(Math.max(0, index - 1));
          else if (event.key === "ArrowRight") choose(Math.min(keyframes.length - 1, index + 1));
          else if (event.key === "Home") choose(0);
          else if (event.key === "End") choose(keyframes.length - 1);
          else if (event.key === "Enter") choose(index);
          else if (event.key === " ") actions.get("play").run();
          else if (event.key === "Delete" || event.key === "Backspace") remove(index);
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
              name={keyframeLabel(scene, index)}
              keyframe={keyframe}
              place={place}
              isSelected={isSelected(index)}
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
                  // A finger scrolls; it takes hold only of the keyframe that is selected.
                  if (event.pointerType === "touch" && !isSelected(index)) return;
                  event.stopPropagation();
                  event.currentTarget.setPointerCapture(event.pointerId);
                  dragging.press(index, viewport.trackX(event.clientX, event.currentTarget), playback.time.peek());
                },
                onPointerMove(event) {
                  dragging.move({
                    x: viewport.trackX(event.clientX, event.currentTarget),
                    isRipple: event.altKey,
                  });
                },
                onPointerUp() {
                  const dragged = dragging.release();
                  isDragOver.current = dragged !== null;
                  if (dragged !== null) choose(dragged);
                },
                onPointerCancel() {
                  dragging.cancel();
                },
                onClick() {
                  // The click that ends a drag is no click on a keyframe.
                  if (!isDragOver.current) choose(index);
                  isDragOver.current = false;
                },
                onContextMenu(event) {
                  event.preventDefault();
                  choose(index);
                  setMenuAt(index);
                },
              }}
            />
          );
        })}
      </div>
      {menuAt !== null && menuAnchor && (
        <KeyframeMenu
          index={menuAt}
          anchor={menuAnchor}
          onClose={(index) => {
            setMenuAt(null);
            choose(index);
          }}
        />
      )}
    </>
  );
}

function option(list: HTMLElement | null, index: number): HTMLElement | null {
  return list?.querySelector<HTMLElement>(`[data-index="${index}"]`) ?? null;
}

function indexOf(target: EventTarget | null): number | null {
  const index = target instanceof HTMLElement ? target.dataset.index : undefined;
  return index === undefined ? null : Number(index);
}
