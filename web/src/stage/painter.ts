import type { Canvases } from "./canvases";
import type { Cast } from "./cast";
import type { HandlesPicture } from "./draw-handles";
import { createMotionPainter, type MotionPicture, outlinedGroup } from "./draw-motion";
import { Frame } from "./frame";
import type { StageInputs } from "./inputs";
import { later } from "./later";
import { drawBackdrop } from "./layers/backdrop";
import { drawGhosts, drawTargets } from "./layers/onion";
import { liftsOf } from "./lifts";
import { Onion } from "./onion";
import type { Palette } from "./palette";
import { createSceneryKeeper } from "./scenery";
import { spacingAt, transitionSpacing } from "./spacing";
import type { Subject } from "./subject";

/** Most shows have nothing in the way. */
const inTheWay = later(() => import("./layers/obstacles"));
/** Mostly everybody is there throughout. */
const appearing = later(() => import("./presence"));
/** Nothing is selected at first. */
const handiwork = later(() => import("./draw-handles"));

/** Which canvases show something old. */
export interface Needs {
  backdrop: boolean;
  motion: boolean;
  handles: boolean;
}

/** The theme and who is on stage in it. */
export interface Look {
  readonly palette: Palette;
  readonly cast: Cast;
}

export interface Painter {
  /**
   * Draws what is needed, and the backdrop when the onion skin on it is another's.
   *
   * Called outside of effects, it reads signals by value: a peek makes a closure, and there are dozens in a frame.
   */
  paint(look: Look, needs: Readonly<Needs>, isSparing: boolean): void;
}

/** Draws the stage as the signals say it is now. */
export function createPainter(inputs: StageInputs, subject: Subject, canvases: Canvases, look: Look): Painter {
  const { scene, selection, playback, view, toolbox } = inputs;
  const sceneryFor = createSceneryKeeper();
  const onion = new Onion();
  const frame = new Frame(look.palette, look.cast);
  const moving: MotionPicture = {
    scene: scene.peek(),
    track: subject.track.peek(),
    show: subject.show.peek(),
    lastMotions: [],
    scenery: { ties: [], hulls: [] },
    layers: view.layers.peek(),
    outlined: null,
    isMarked: null,
    isTying: false,
    areHeightsShown: true,
    time: 0,
  };
  const handles: HandlesPicture = {
    selection: selection.peek(),
    selected: new Set(),
    hovered: null,
    overlay: { kind: "none" },
    areNamesShown: true,
    hasBox: false,
    lifts: "nobody",
    ties: null,
  };
  const paintMoving = createMotionPainter(frame, moving, canvases.scratch);

  function update(): void {
    moving.scene = scene.value;
    moving.track = subject.track.value;
    moving.show = subject.show.value;
    moving.time = playback.time.value;
    const { track, show, time } = moving;
    frame.look(view.camera.value, view.size.value, canvases.density, spacingAt(track, time));
    frame.resize(track.agents.length, show.isSpatial);
    show.positionsInto(time, frame.places);
    if (frame.heights) show.heightsInto(time, frame.heights);
    frame.miss(show.absentAt(time));
    const part = track.keyframes.some(({ absent }) => absent.length > 0) ? appearing() : null;
    if (part) part.presenceInto(frame.appear(), track, show, time);
    else frame.presence = null;
    frame.project();
  }

  function updateMoving(): void {
    const { track, show, time } = moving;
    const index = show.keyframeBefore(time);
    moving.lastMotions = subject.lastMotions.value;
    moving.scenery = sceneryFor(track, frame.cast, subject.ties.value, index, show.segmentAt(time) !== null);
    moving.layers = view.layers.value;
    const tool = toolbox.active.value;
    moving.outlined = outlinedGroup(moving.scene, selection.value, view.hovered.value, tool === "group");
    moving.isMarked = subject.isMarked.value;
    moving.isTying = tool === "tie";
    // From the front heights are seen.
    moving.areHeightsShown = view.projection.value !== "front";
  }

  function updateHandles(): void {
    handles.selection = selection.value;
    handles.selected = subject.selected.value;
    handles.hovered = view.hovered.value;
    handles.overlay = toolbox.overlay.value;
    handles.areNamesShown = view.layers.value.names;
    const { kind } = handles.selection;
    const isSelecting = toolbox.active.value === "select" && (kind === "agents" || kind === "group");
    handles.hasBox = isSelecting && !playback.isPlaying.value && handles.overlay.kind !== "marquee";
    handles.lifts = liftsOf(view.projection.value, moving.show.isSpatial);
    handles.ties = subject.ties.value[moving.show.keyframeBefore(moving.time)] ?? null;
  }

  function paintBackdrop(): void {
    const { spacing, radius } = frame;
    const context = canvases.backdrop;
    drawBackdrop(context, frame, moving.scene.stage);
    const chosen = selection.value;
    const { obstacles } = moving.scene;
    if (obstacles.length > 0) {
      inTheWay()?.drawObstacles(context, frame, obstacles, chosen.kind === "obstacle" ? chosen.index : null);
    }
    if (view.layers.value.ghosts) {
      frame.look(frame.camera, frame.size, frame.density, transitionSpacing(moving.track, onion.segment));
      if (onion.from) drawGhosts(context, frame, onion.from.positions.xy, onion.goneFrom);
      if (onion.to) drawTargets(context, frame, onion.to.positions.xy, onion.goneTo);
    }
    frame.spacing = spacing;
    frame.radius = radius;
  }

  function paintHandles(): void {
    const isEmpty = handles.selected.size === 0 && handles.hovered === null && handles.overlay.kind === "none";
    // An empty sheet laid over the others would cost every frame.
    canvases.handles.canvas.hidden = isEmpty;
    if (!isEmpty) handiwork()?.drawHandles(canvases.handles, frame, handles);
  }

  return {
    paint({ palette, cast }, needs, isSparing) {
      frame.palette = palette;
      frame.cast = cast;
      if (needs.motion || needs.backdrop) update();
      const isOtherOnion = onion.take(moving.track, moving.show, moving.time);
      if (needs.backdrop || isOtherOnion) paintBackdrop();
      if (needs.motion) {
        updateMoving();
        paintMoving(canvases.motion, isSparing);
      }
      updateHandles();
      if (needs.handles || (needs.motion && !canvases.handles.canvas.hidden)) paintHandles();
    },
  };
}
