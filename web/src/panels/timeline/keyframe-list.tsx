import { useEffect, useRef, useState } from "preact/hooks";
import { keyframeLabel } from "../../document/queries";
import { isInRun, selectedRun } from "../../document/run";
import { mainTrack } from "../../document/scene";
import { liesBetween } from "../../document/stretches";
import { later } from "../../stage/later";
import { breachesOf, obstacleBreachCount } from "../breaches";
import { lazily } from "../lazily";
import { useStudio } from "../studio";
import { shortTime } from "./clock";
import type { KeyframeHands } from "./keyframe-keys";
import { KeyframeOption } from "./keyframe-option";
import { LaterDrag } from "./later-drag";
import { keyframePlaces, nameWidths } from "./layout";
import { THUMBNAIL_WIDTH, xOf } from "./scale";
import { useAgentColors, usePalette } from "./use-paint";
import type { Viewport } from "./viewport";

const KeyframeMenu = lazily(() => import("./keyframe-menu").then((part) => part.KeyframeMenu));
const LimitNote = lazily(() => import("./limit-note").then((part) => part.LimitNote));
const keys = later(() => import("./keyframe-keys"));

/** The formations of the show at their times. Arrows walk, a drag retimes, a drag onto another takes its place. */
export function KeyframeList({ viewport }: { viewport: Viewport }) {
  const { actions, document, playback, messages, planner, view } = useStudio();
  const [menuAt, setMenuAt] = useState<number | null>(null);
  const list = useRef<HTMLDivElement | null>(null);
  const drag = useRef<LaterDrag>(null);
  drag.current ??= new LaterDrag(document, { scale: () => viewport.scale.peek(), ruler: () => view.ruler.peek() });
  const dragging = drag.current;
  const isDragOver = useRef(false);
  useEffect(() => void keys(), []);

  const scene = document.scene.value;
  const track = mainTrack(scene);
  const { keyframes } = track;
  const places = keyframePlaces(keyframes, viewport.scale.value);
  const { from, to } = viewport.drawn.value;
  const selection = document.selection.value;
  const run = selectedRun(selection);
  const plans = planner.segments.value;
  const state = dragging.state.value;
  const paint = { colors: useAgentColors().value, palette: usePalette() };
  const active = Math.min(document.activeKeyframe.value, keyframes.length - 1);

  const names = nameWidths(places, active);

  const isSelected = (index: number) =>
    selection.kind === "keyframe" && (selection.index === index || isInRun(run, index));

  const focus = (index: number) => option(list.current, index)?.focus({ preventScroll: true });

  const choose = (index: number, anchor: number | null = null) => {
    const keyframe = mainTrack(document.scene.peek()).keyframes[index];
    if (!keyframe) return;
    document.selection.value = { kind: "keyframe", index, ...(anchor === null ? {} : { anchor }) };
    document.activeKeyframe.value = index;
    playback.seek(keyframe.time);
    viewport.reveal(keyframe.time);
    focus(index);
  };

  const extend = (index: number) => {
    const now = document.selection.peek();
    choose(index, now.kind === "keyframe" ? (now.anchor ?? now.index) : active);
  };

  const reorder = async (index: number, other: number) => {
    const { reorderKeyframe } = await import("../../document/commands/keyframes");
    document.perform(reorderKeyframe(index, other));
    choose(other);
    messages.announce(`Moved to place ${other + 1} of ${keyframes.length}`);
  };

  const hands: KeyframeHands = {
    count: keyframes.length,
    choose,
    extend,
    reorder: (index, other) => void reorder(index, other),
    remove(index) {
      choose(index);
      if (keyframes.length > 1) actions.get("delete-keyframe").run();
      queueMicrotask(() => focus(document.activeKeyframe.peek()));
    },
    play: () => actions.get("play").run(),
    cancelDrag() {
      if (state.kind === "idle") return false;
      dragging.cancel();
      return true;
    },
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
        aria-multiselectable="true"
        onKeyDown={(event) => {
          const index = indexOf(event.target);
          if (index === null || !keys()?.pressKey(event, index, hands)) return;
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
              nameWidth={names[index] ?? 0}
              isSelected={isSelected(index)}
              isFocusable={index === active}
              breachCount={
                breachesOf(keyframe.positions, scene.minimumDistance).length + obstacleBreachCount(plans, index)
              }
              isBetween={liesBetween(track, index)}
              isCorner={keyframe.corner && scene.join !== "separate"}
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
                onClick(event) {
                  // The click that ends a drag is no click on a keyframe.
                  const isDrag = isDragOver.current;
                  isDragOver.current = false;
                  if (isDrag) return;
                  if (event.shiftKey) extend(index);
                  else choose(index);
                },
                onContextMenu(event) {
                  event.preventDefault();
                  if (!isInRun(run, index)) choose(index);
                  setMenuAt(index);
                },
              }}
            />
          );
        })}
      </div>
      {state.kind === "retiming" && state.stop !== null && (
        <LimitNote
          what={keyframeLabel(scene, state.index)}
          stop={shortTime(state.stop)}
          anchor={option(list.current, state.index)}
        />
      )}
      {menuAt !== null && menuAnchor && (
        <KeyframeMenu
          index={menuAt}
          anchor={menuAnchor}
          onClose={(moved) => {
            setMenuAt(null);
            if (moved === null) focus(document.activeKeyframe.peek());
            else choose(moved);
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
