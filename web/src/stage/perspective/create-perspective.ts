import "./perspective.css";
import { computed, effect, type ReadonlySignal } from "@preact/signals";
import { selectedAgents } from "../../document/queries";
import { mainTrack, type Scene } from "../../document/scene";
import type { Selection } from "../../document/selection";
import type { Playback } from "../../playback/playback";
import type { Show } from "../../playback/show";
import { castOf } from "../cast";
import { onDensityChange } from "../density";
import { arrivals } from "../later";
import { createLoop } from "../loop";
import { createPace } from "../pace";
import type { Lens, View } from "../view";
import { watchPalette } from "../watch-palette";
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

/** What the perspective view looks at. It changes none of it but who is hovered and, playing, the time. */
export interface PerspectiveInputs {
  readonly scene: ReadonlySignal<Scene>;
  readonly selection: ReadonlySignal<Selection>;
  readonly show: ReadonlySignal<Show>;
  readonly playback: Playback;
  readonly view: View;
  readonly bodies: ReadonlySignal<BodyKind>;
  readonly isMac: boolean;
  /** Somebody was pressed, or nobody. */
  onPick(agent: number | null, way: PickWay): void;
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
  const { scene, selection, show, playback, view } = inputs;
  const track = computed(() => mainTrack(scene.value));
  const sizes = computed(() => bodySizes(track.value));
  const eye = createEye(scene, view, sizes);
  const picture: WorldPicture = {
    show: show.peek(),
    time: 0,
    isSparing: false,
    stage: scene.peek().stage,
    obstacles: [],
    kind: inputs.bodies.peek(),
    sizes: sizes.peek(),
    hasTrails: true,
    selected: new Set(),
    hovered: null,
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
  const selected = computed(() => selectedAgents(scene.value, selection.value));
  const finger = createFinger();
  const needs: WorldNeeds = { ground: true, cast: true, poses: true };

  const pace = createPace(COARSE_FROM);
  const loop = createLoop((elapsed) => {
    pace.note(elapsed);
    if (playback.isPlaying.peek()) playback.tick(elapsed);
    draw();
    return playback.isPlaying.peek();
  }, globalThis);

  function need(...parts: (keyof WorldNeeds)[]): void {
    for (const part of parts) needs[part] = true;
    loop.invalidate();
  }

  function draw(): void {
    const palette = watch.palette.peek();
    const who = cast.peek();
    if (!palette || !who || view.size.peek().width === 0) return;
    picture.show = show.peek();
    picture.time = playback.time.peek();
    picture.isSparing = playback.isPlaying.peek() && pace.isSparing;
    picture.kind = inputs.bodies.peek();
    picture.sizes = sizes.peek();
    picture.hasTrails = view.layers.peek().trails;
    picture.stage = scene.peek().stage;
    picture.obstacles = scene.peek().obstacles;
    picture.selected = selected.peek();
    picture.hovered = view.hovered.peek();
    picture.orbit = eye.orbit.peek();
    world.paint(palette, who, eye.sight(), needs);
    needs.ground = false;
    needs.cast = false;
    needs.poses = false;
  }

  const steering: Steering = {
    turn: eye.turn,
    slide: eye.slide,
    zoom: eye.zoom,
    hover(at, slack) {
      view.hovered.value = at && finger(world.bodies(), eye.sight(), at, slack);
    },
    pick(at, slack, way) {
      inputs.onPick(finger(world.bodies(), eye.sight(), at, slack), way);
    },
  };

  function resize(): void {
    world.resize(view.size.peek());
    // In this very frame: a resized canvas is empty until it is drawn on.
    draw();
  }

  const stops = [
    effect(() => {
      void view.size.value;
      resize();
    }),
    effect(() => {
      void [watch.palette.value, stage.value, obstacles.value, height.value, arrivals.value];
      need("ground");
    }),
    effect(() => {
      void [cast.value, selected.value];
      need("cast");
    }),
    effect(() => {
      void [playback.time.value, show.value, inputs.bodies.value, sizes.value, view.layers.value];
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
