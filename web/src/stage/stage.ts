import "./stage.css";
import { computed, effect, untracked } from "@preact/signals";
import { createCanvases } from "./canvases";
import { castOf } from "./cast";
import { onDensityChange } from "./density";
import type { StageInputs } from "./inputs";
import { arrivals, later } from "./later";
import { createLoop } from "./loop";
import { createPace } from "./pace";
import { createPainter, type Look, type Needs, type Painter } from "./painter";
import { createSubject } from "./subject";
import { watchPalette } from "./watch-palette";

/** Not for those who find their own scene here, or an example. */
const emptyState = later(() => import("./empty-state"));

export interface Stage {
  /** Stops drawing and leaves the host as it was. */
  dispose(): void;
}

/** Draws the show into `host`, which may come into the page later. No frame is drawn when nothing changes. */
export function createStage(host: HTMLElement, inputs: StageInputs): Stage {
  const { scene, selection, segments, playback, view, toolbox } = inputs;
  host.classList.add("stage-sheet");
  const canvases = createCanvases(host);
  let empty: HTMLElement | null = null;

  const watch = watchPalette(host, view.theme);
  const { palette } = watch;
  const subject = createSubject(scene, selection, segments, inputs.ties);
  const { track, show } = subject;
  const agents = computed(() => track.value.agents);
  const groups = computed(() => scene.value.groups);
  const obstacles = computed(() => scene.value.obstacles);
  /** The obstacle that is selected. */
  const chosen = computed(() => (selection.value.kind === "obstacle" ? selection.value.index : null));
  const look = computed<Look | null>(() => {
    // Only agents and groups have colors and names; moving somebody keeps the cast.
    void agents.value;
    void groups.value;
    return palette.value ? { palette: palette.value, cast: castOf(scene.peek(), palette.value) } : null;
  });

  const needs: Needs = { backdrop: true, motion: true, handles: true };
  const pace = createPace();
  let painter: Painter | null = null;
  /** What nobody sees is not drawn; the view that covers it plays the show meanwhile. */
  let isCovered = false;

  const loop = createLoop((elapsed) => {
    if (isCovered) return false;
    pace.note(elapsed);
    playback.tick(elapsed);
    draw();
    return playback.isPlaying.value;
  }, globalThis);

  function need(...parts: (keyof Needs)[]): void {
    for (const part of parts) needs[part] = true;
    if (!isCovered) loop.invalidate();
  }

  /** Outside of effects. */
  function draw(): void {
    const current = look.value;
    if (!current || view.size.value.width === 0) return;
    painter ??= createPainter(inputs, subject, canvases, current);
    painter.paint(current, needs, pace.isSparing && playback.isPlaying.value);
    needs.backdrop = false;
    needs.motion = false;
    needs.handles = false;
  }

  function measure(): void {
    const { clientWidth: width, clientHeight: height } = host;
    if (width === 0 || height === 0) return;
    watch.read();
    canvases.resize({ width, height });
    view.size.value = { width, height };
    // In this very frame: a resized canvas is empty until it is drawn on.
    needs.backdrop = true;
    needs.motion = true;
    needs.handles = true;
    untracked(draw);
  }

  const observer = new ResizeObserver(measure);
  observer.observe(host);
  const stopDensity = onDensityChange(measure);

  const stops = [
    playback.follow(() => {
      needs.motion = true;
      if (!isCovered) loop.invalidate();
    }),
    effect(() => {
      isCovered = view.lens.value !== null;
      void [view.camera.value, look.value, view.layers.value, scene.value.stage];
      void [obstacles.value, chosen.value];
      need("backdrop", "motion", "handles");
    }),
    effect(() => {
      void arrivals.value;
      need("backdrop", "motion", "handles");
    }),
    effect(() => {
      void [show.value, subject.ties.value, scene.value, toolbox.active.value];
      need("motion");
    }),
    effect(() => {
      void [selection.value, subject.isMarked.value, playback.isPlaying.value];
      need("motion", "handles");
    }),
    effect(() => {
      void [toolbox.overlay.value, view.hovered.value];
      need("handles");
      if (toolbox.active.value === "group") need("motion");
    }),
    effect(() => {
      host.style.cursor = toolbox.cursor.value;
    }),
    effect(() => {
      host.style.visibility = inputs.isSettled.value ? "" : "hidden";
    }),
    effect(() => {
      void arrivals.value;
      const isBare = agents.value.length === 0 && obstacles.value.length === 0;
      const isShown = inputs.isSettled.value && isBare && toolbox.overlay.value.kind === "none";
      if (isShown && !empty) {
        empty = emptyState()?.createEmptyState() ?? null;
        if (empty) host.append(empty);
      }
      if (empty) empty.hidden = !isShown;
    }),
  ];

  return {
    dispose() {
      for (const stop of stops) stop();
      loop.stop();
      observer.disconnect();
      stopDensity();
      watch.stop();
      host.classList.remove("stage-sheet");
      host.replaceChildren();
    },
  };
}
