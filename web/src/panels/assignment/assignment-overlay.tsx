import "./assignment.css";
import { effect, useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import type { Formation, Point } from "../../document/formation";
import { mainTrack } from "../../document/scene";
import { toStage } from "../../stage/camera";
import { fitCanvas } from "../fit-canvas";
import { useStudio } from "../studio";
import { useAgentColors, usePalette } from "../timeline/use-paint";
import { openTrial } from "./create-trial";
import { drawTrial, type TrialSketch } from "./draw-trial";
import { nearestTo, withStays } from "./walks";
import { waysAlong } from "./ways";

/** CSS pixels from the pointer within which an agent or a place is meant. */
const REACH = 22;

/** Wheel pixels that double the scale, as on the stage. */
const WHEEL_DOUBLING = 400;

type Doing =
  | { readonly kind: "nothing" }
  | { readonly kind: "locking"; readonly agent: number; readonly at: Point; readonly slot: number | null }
  | { readonly kind: "panning"; readonly x: number; readonly y: number };

const NOTHING: Doing = { kind: "nothing" };

/** The trial over the stage: who drags an agent to a place locks it there, and lets it go beside all places. */
export function AssignmentOverlay() {
  const { document, planner, view } = useStudio();
  const canvas = useRef<HTMLCanvasElement>(null);
  const palette = usePalette();
  const stored = useAgentColors();
  const doing = useSignal<Doing>(NOTHING);

  function ends(): readonly [from: Formation, to: Formation] | null {
    const segment = openTrial.value?.question.value.segment ?? -1;
    const { keyframes } = mainTrack(document.scene.value);
    const [from, to] = [keyframes[segment]?.positions, keyframes[segment + 1]?.positions];
    return from && to ? [from, to] : null;
  }

  useEffect(
    () =>
      effect(() => {
        const [camera, size, trial, places] = [view.camera.value, view.size.value, openTrial.value, ends()];
        const colors = stored.value.map((color) => palette.shown(color));
        const context = canvas.current && fitCanvas(canvas.current, size);
        if (!context || !trial || !places) return;
        const drag = doing.value.kind === "locking" ? doing.value : null;
        const { locks } = trial.question.value.recipe;
        const { obstacles } = document.scene.value;
        const found = trial.found.value;
        const { rest, segment } = trial.question.value;
        const absent = mainTrack(document.scene.value).keyframes[segment + 1]?.absent ?? [];
        const [from, target] = places;
        const { to, bends } =
          found && rest === "stay" ? withStays(from, target, absent, found) : { to: target, bends: found?.bends ?? [] };
        const planning = planner.segments.value[segment];
        const motion = planning?.kind === "ready" ? planning.plan.motion : null;
        const ways = found ? waysAlong(motion, to, found.slots, bends) : bends;
        const sketch: TrialSketch = { from, to, slots: found?.slots ?? null, bends, ways, locks, drag, obstacles };
        drawTrial(context, sketch, { camera, size, palette, colors });
      }),
    [view, palette, stored, planner],
  );

  const placeOf = (event: MouseEvent): Point => toStage(view.camera.peek(), { x: event.offsetX, y: event.offsetY });
  const reach = () => REACH / view.camera.peek().scale;

  function onPointerDown(event: PointerEvent): void {
    const places = ends();
    if (!places || doing.value.kind !== "nothing") return;
    canvas.current?.setPointerCapture(event.pointerId);
    const at = placeOf(event);
    const agent = event.button === 0 ? nearestTo(at, places[0], reach()) : null;
    doing.value =
      agent === null
        ? { kind: "panning", x: event.clientX, y: event.clientY }
        : { kind: "locking", agent, at, slot: null };
  }

  function onPointerMove(event: PointerEvent): void {
    const [now, places] = [doing.value, ends()];
    if (now.kind === "panning") {
      view.panBy(event.clientX - now.x, event.clientY - now.y);
      doing.value = { kind: "panning", x: event.clientX, y: event.clientY };
    } else if (now.kind === "locking" && places) {
      const at = placeOf(event);
      doing.value = { ...now, at, slot: nearestTo(at, places[1], reach()) };
    }
  }

  function onPointerUp(): void {
    const [now, trial] = [doing.value, openTrial.value];
    doing.value = NOTHING;
    if (now.kind !== "locking" || !trial) return;
    if (now.slot !== null) trial.lock(now.agent, now.slot);
    else trial.unlock(now.agent);
  }

  return (
    <div aria-hidden="true">
      <canvas
        ref={canvas}
        class="assignment-canvas"
        onPointerDown={onPointerDown}
        onPointerMove={onPointerMove}
        onPointerUp={onPointerUp}
        onPointerCancel={() => {
          doing.value = NOTHING;
        }}
        onWheel={(event) => {
          event.preventDefault();
          view.zoomBy(2 ** (-event.deltaY / WHEEL_DOUBLING), { x: event.offsetX, y: event.offsetY });
        }}
      />
    </div>
  );
}
