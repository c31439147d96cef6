import "./stage.css";
import { computed, effect, type ReadonlySignal, signal } from "@preact/signals";
import type { Scene } from "../document/scene";
import type { Selection } from "../document/selection";
import type { Planning, TieList } from "../engine/api";
import type { Playback } from "../playback/playback";
import type { Toolbox } from "../tools/toolbox";
import { createCanvases } from "./canvases";
import { type Cast, castOf } from "./cast";
import { drawHandles } from "./draw-handles";
import { createMotionPainter } from "./draw-motion";
import { createEmptyState } from "./empty-state";
import { Frame } from "./frame";
import { drawBackdrop } from "./layers/backdrop";
import { drawGhosts, drawTargets } from "./layers/onion";
import { createLoop } from "./loop";
import { onionAt } from "./onion";
import { createPace } from "./pace";
import { type Palette, paletteOf } from "./palette";
import { createSceneryKeeper } from "./scenery";
import { spacingAt, transitionSpacing } from "./spacing";
import { createSubject } from "./subject";
import type { View } from "./view";

/** What the stage looks at. It changes none of it but the size of the view and, playing, the time. */
export interface StageInputs {
  readonly scene: ReadonlySignal<Scene>;
  readonly selection: ReadonlySignal<Selection>;
  readonly segments: ReadonlySignal<readonly Planning[]>;
  readonly ties: ReadonlySignal<readonly (TieList | null)[]>;
  readonly playback: Playback;
  readonly view: View;
  readonly toolbox: Pick<Toolbox, "active" | "overlay" | "cursor">;
}

export interface Stage {
  /** Stops drawing and leaves the host as it was. */
  dispose(): void;
}

/** Draws the show into `host`, which may come into the page later. No frame is drawn when nothing changes. */
export function createStage(host: HTMLElement, inputs: StageInputs): Stage {
  const { scene, selection, segments, playback, view, toolbox } = inputs;
  host.classList.add("stage-sheet");
  const canvases = createCanvases(host);
  const empty = createEmptyState();
  host.append(empty);

  const palette = signal<Palette | null>(null);
  const subject = createSubject(scene, selection, segments, inputs.ties);
  const { track, show, selected } = subject;
  const agents = computed(() => track.value.agents);
  const groups = computed(() => scene.value.groups);
  const cast = computed<Cast | null>(() => {
    // Only agents and groups have colors and names; moving somebody keeps the cast.
    void agents.value;
    void groups.value;
    return palette.value ? castOf(scene.peek(), palette.value) : null;
  });

  const needs = { backdrop: true, motion: true, handles: true };
  const pace = createPace();
  const paintMotion = createMotionPainter();
  const sceneryFor = createSceneryKeeper();
  let frame: Frame | null = null;
  let drawnOnion: ReturnType<typeof onionAt> | null = null;

  const loop = createLoop((elapsed) => {
    pace.note(elapsed);
    if (playback.isPlaying.peek()) playback.tick(elapsed);
    draw();
    return playback.isPlaying.peek();
  }, globalThis);

  function need(...parts: (keyof typeof needs)[]): void {
    for (const part of parts) needs[part] = true;
    loop.invalidate();
  }

  function draw(): void {
    const look = palette.peek();
    const actors = cast.peek();
    const size = view.size.peek();
    if (!look || !actors || size.width === 0) return;
    frame ??= new Frame(look, actors);
    frame.palette = look;
    frame.cast = actors;
    if (needs.motion || needs.backdrop) updateFrame(frame);
    if (needs.backdrop || hasOtherOnion()) paintBackdrop(frame);
    if (needs.motion) paintMoving(frame);
    if (needs.handles || (needs.motion && hasHandles())) paintHandles(frame);
    needs.backdrop = false;
    needs.motion = false;
    needs.handles = false;
  }

  function updateFrame(into: Frame): void {
    const time = playback.time.peek();
    into.look(view.camera.peek(), view.size.peek(), canvases.density, spacingAt(track.peek(), time));
    into.resize(track.peek().agents.length);
    show.peek().positionsInto(time, into.places);
    into.project();
  }

  function hasOtherOnion(): boolean {
    const next = onionAt(track.peek(), show.peek(), playback.time.peek());
    return next.from !== drawnOnion?.from || next.to !== drawnOnion?.to;
  }

  function paintBackdrop(into: Frame): void {
    const { spacing, radius } = into;
    drawnOnion = onionAt(track.peek(), show.peek(), playback.time.peek());
    drawBackdrop(canvases.backdrop, into, scene.peek().stage);
    if (view.layers.peek().ghosts) {
      into.look(into.camera, into.size, into.density, transitionSpacing(track.peek(), drawnOnion.segment));
      if (drawnOnion.from) drawGhosts(canvases.backdrop, into, drawnOnion.from.xy);
      if (drawnOnion.to) drawTargets(canvases.backdrop, into, drawnOnion.to.xy);
    }
    into.spacing = spacing;
    into.radius = radius;
  }

  function paintMoving(into: Frame): void {
    const time = playback.time.peek();
    const index = show.peek().keyframeBefore(time);
    const isMoving = show.peek().segmentAt(time) !== null;
    paintMotion(
      canvases.motion,
      into,
      {
        scene: scene.peek(),
        track: track.peek(),
        show: show.peek(),
        lastMotions: subject.lastMotions.peek(),
        scenery: sceneryFor(track.peek(), into.cast, subject.ties.peek(), index, isMoving),
        layers: view.layers.peek(),
        selection: selection.peek(),
        isMarked: subject.isMarked.peek(),
        isTying: toolbox.active.peek() === "tie",
        time,
      },
      canvases.scratch,
      pace.isSparing && playback.isPlaying.peek(),
    );
  }

  function hasHandles(): boolean {
    return selected.peek().size > 0 || view.hovered.peek() !== null || toolbox.overlay.peek().kind !== "none";
  }

  function paintHandles(into: Frame): void {
    // An empty sheet laid over the others would cost every frame.
    canvases.handles.canvas.hidden = !hasHandles();
    if (!hasHandles()) return;
    const isSelecting = toolbox.active.peek() === "select" && selection.peek().kind === "agents";
    drawHandles(canvases.handles, into, {
      selection: selection.peek(),
      selected: selected.peek(),
      hovered: view.hovered.peek(),
      overlay: toolbox.overlay.peek(),
      areNamesShown: view.layers.peek().names,
      hasBox: isSelecting && !playback.isPlaying.peek() && toolbox.overlay.peek().kind !== "marquee",
      ties: subject.ties.peek()[show.peek().keyframeBefore(playback.time.peek())] ?? null,
    });
  }

  function measure(): void {
    const { clientWidth: width, clientHeight: height } = host;
    if (width === 0 || height === 0) return;
    palette.value = paletteOf(host);
    canvases.resize({ width, height });
    view.size.value = { width, height };
    // In this very frame: a resized canvas is empty until it is drawn on.
    for (const part of ["backdrop", "motion", "handles"] as const) needs[part] = true;
    draw();
  }

  function readPalette(): void {
    if (host.isConnected) palette.value = paletteOf(host);
  }

  const observer = new ResizeObserver(measure);
  observer.observe(host);
  const systemTheme = matchMedia("(prefers-color-scheme: dark)");
  systemTheme.addEventListener("change", readPalette);

  const stops = [
    effect(() => {
      void view.theme.value;
      // The page's theme attribute follows the same signal; by the next frame it is set.
      requestAnimationFrame(readPalette);
    }),
    effect(() => {
      void [view.camera.value, cast.value, view.layers.value, scene.value.stage];
      need("backdrop", "motion", "handles");
    }),
    effect(() => {
      void [playback.time.value, show.value, subject.ties.value, scene.value, toolbox.active.value];
      need("motion");
    }),
    effect(() => {
      void [selection.value, subject.isMarked.value, playback.isPlaying.value];
      need("motion", "handles");
    }),
    effect(() => {
      void [toolbox.overlay.value, toolbox.active.value, view.hovered.value];
      need("handles");
    }),
    effect(() => {
      host.style.cursor = toolbox.cursor.value;
    }),
    effect(() => {
      empty.hidden = agents.value.length > 0 || toolbox.overlay.value.kind !== "none";
    }),
  ];

  return {
    dispose() {
      for (const stop of stops) stop();
      loop.stop();
      observer.disconnect();
      systemTheme.removeEventListener("change", readPalette);
      host.classList.remove("stage-sheet");
      host.replaceChildren();
    },
  };
}
