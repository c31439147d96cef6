import "./perspective.css";
import { computed, effect, type ReadonlySignal, untracked } from "@preact/signals";
import type { Scene } from "../../document/scene";
import type { Selection } from "../../document/selection";
import type { Planning, TieList } from "../../engine/api";
import type { Playback } from "../../playback/playback";
import type { ScreenPoint } from "../camera";
import { castOf } from "../cast";
import { onDensityChange } from "../density";
import { arrivals } from "../later";
import { createLoop } from "../loop";
import { createPace } from "../pace";
import { createSceneryKeeper } from "../scenery";
import { createSubject } from "../subject";
import type { Lens, View } from "../view";
import { watchPalette } from "../watch-palette";
import { blockAt } from "./block-pick";
import type { BodyKind } from "./bodies";
import { createEye } from "./eye";
import { createFinger } from "./finger";
import { attachKeys } from "./keys";
import { attachPointer } from "./pointer";
import { bodySizes } from "./sizes";
import type { Steering } from "./steering";
import { createWorld, type WorldNeeds, type WorldPicture } from "./world";

/** Frames longer than this, seconds, are drawn coarser while the show plays. */
const COARSE_FROM = 1 / 22;

/** What a press does to the selection. */
export type PickWay = "replace" | "add" | "toggle";

/** What was pressed. */
export type Picked =
  | { readonly kind: "agent"; readonly agent: number }
  | { readonly kind: "obstacle"; readonly index: number }
  | { readonly kind: "nothing" };

/** What the perspective view looks at. It changes none of it but who is hovered and, playing, the time. */
export interface PerspectiveInputs {
  readonly scene: ReadonlySignal<Scene>;
  readonly selection: ReadonlySignal<Selection>;
  readonly segments: ReadonlySignal<readonly Planning[]>;
  readonly ties: ReadonlySignal<readonly (TieList | null)[]>;
  readonly playback: Playback;
  readonly view: View;
  readonly bodies: ReadonlySignal<BodyKind>;
  readonly isMac: boolean;
  onPick(picked: Picked, way: PickWay): void;
  /** The graphics device is gone; the view shows nothing anymore. */
  onLost(): void;
}

/** The show as it is seen from a place in the room. */
export interface Perspective extends Lens {
  /** Flies to a seat in the audience. */
  sitDown(): void;
  dispose(): void;
}

/**
 * Draws the show in perspective into `host`, which is in the page. No frame is drawn when nothing changes.
 *
 * Throws `NoGraphics` where the browser draws nothing in three dimensions.
 */
export function createPerspective(host: HTMLElement, inputs: PerspectiveInputs): Perspective {
  const { scene, selection, playback, view } = inputs;
  const subject = createSubject(scene, selection, inputs.segments, inputs.ties);
  const { track, show, selected } = subject;
  const sceneryFor = createSceneryKeeper();
  const sizes = computed(() => bodySizes(track.value));
  const eye = createEye(scene, view, sizes);
  const picture: WorldPicture = {
    show: show.peek(),
    track: track.peek(),
    time: 0,
    scenery: { ties: [], hulls: [] },
    isMarked: null,
    isSparing: false,
    stage: scene.peek().stage,
    units: "m",
    obstacles: [],
    chosen: null,
    kind: inputs.bodies.peek(),
    sizes: sizes.peek(),
    layers: view.layers.peek(),
    selected: new Set(),
    hovered: null,
    minimumDistance: 0,
    orbit: eye.orbit.peek(),
  };
  const world = createWorld(host, picture, inputs.onLost);
  const watch = watchPalette(host, view.theme);
  watch.read();
  const agents = computed(() => track.value.agents);
  const groups = computed(() => scene.value.groups);
  const stage = computed(() => scene.value.stage);
  const obstacles = computed(() => scene.value.obstacles);
  const height = computed(() => sizes.value.figure);
  const cast = computed(() => {
    // Only agents and groups have colors and names; moving somebody keeps the cast.
    void [agents.value, groups.value];
    return watch.palette.value && castOf(scene.peek(), watch.palette.value);
  });
  /** The obstacle that is selected. */
  const chosen = computed(() => (selection.value.kind === "obstacle" ? selection.value.index : null));
  const finger = createFinger();
  const needs: WorldNeeds = { ground: true, cast: true, poses: true };

  const pace = createPace(COARSE_FROM);
  const loop = createLoop((elapsed) => {
    pace.note(elapsed);
    playback.tick(elapsed);
    draw();
    return playback.isPlaying.value;
  }, globalThis);

  function need(...parts: (keyof WorldNeeds)[]): void {
    for (const part of parts) needs[part] = true;
    loop.invalidate();
  }

  /** Outside of effects: signals are read by value, as a peek makes a closure. */
  function draw(): void {
    const palette = watch.palette.value;
    const who = cast.value;
    if (!palette || !who || view.size.value.width === 0) return;
    const { stage: now, obstacles: around, minimumDistance } = scene.value;
    picture.show = show.value;
    picture.track = track.value;
    picture.time = playback.time.value;
    picture.isSparing = playback.isPlaying.value && pace.isSparing;
    picture.kind = inputs.bodies.value;
    picture.sizes = sizes.value;
    picture.layers = view.layers.value;
    picture.stage = now;
    picture.units = now.units;
    picture.obstacles = around;
    picture.chosen = chosen.value;
    picture.minimumDistance = minimumDistance;
    picture.isMarked = subject.isMarked.value;
    const index = picture.show.keyframeBefore(picture.time);
    const isMoving = picture.show.segmentAt(picture.time) !== null;
    picture.scenery = sceneryFor(picture.track, who, subject.ties.value, index, isMoving);
    picture.selected = selected.value;
    picture.hovered = view.hovered.value;
    picture.orbit = eye.orbit.value;
    world.paint(palette, who, eye.sight(), needs);
    needs.ground = false;
    needs.cast = false;
    needs.poses = false;
  }

  function meet(at: ScreenPoint, slack: number): Picked {
    const agent = finger(world.bodies(), eye.sight(), at, slack);
    if (agent !== null) return { kind: "agent", agent };
    const index = blockAt(eye.sight(), obstacles.peek(), world.obstacleHeight(), at);
    return index === null ? { kind: "nothing" } : { kind: "obstacle", index };
  }

  const steering: Steering = {
    turn: eye.turn,
    slide: eye.slide,
    zoom: eye.zoom,
    hover(at, slack) {
      view.hovered.value = at && finger(world.bodies(), eye.sight(), at, slack);
    },
    pick(at, slack, way) {
      inputs.onPick(meet(at, slack), way);
    },
  };

  function resize(): void {
    world.resize(view.size.peek());
    // In this very frame: a resized canvas is empty until it is drawn on.
    untracked(draw);
  }

  const stops = [
    playback.follow(() => {
      needs.poses = true;
      loop.invalidate();
    }),
    effect(() => {
      void view.size.value;
      resize();
    }),
    effect(() => {
      void [watch.palette.value, stage.value, obstacles.value, chosen.value, height.value, arrivals.value];
      need("ground");
    }),
    effect(() => {
      void [cast.value, selected.value];
      need("cast");
    }),
    effect(() => {
      void [show.value, inputs.bodies.value, sizes.value, view.layers.value];
      void [subject.ties.value, scene.value.minimumDistance];
      need("poses");
    }),
    effect(() => {
      void [eye.orbit.value, view.hovered.value, playback.isPlaying.value];
      need();
    }),
    onDensityChange(resize),
    attachPointer(host, steering, inputs.isMac),
    attachKeys(host, steering),
  ];

  return {
    zoomBy: eye.zoom,
    fit: eye.fit,
    sitDown: eye.sitDown,
    dispose() {
      for (const stop of stops) stop();
      loop.stop();
      eye.stop();
      watch.stop();
      world.dispose();
      view.hovered.value = null;
    },
  };
}
