import { computed, effect, type ReadonlySignal, signal } from "@preact/signals";
import { mainTrack, type Scene } from "../../document/scene";
import { type Bounds, grown, type ScreenPoint, union } from "../camera";
import { createGlide, framesForMotion } from "../glide";
import { contentOf, sheetOf } from "../sheet";
import { clamp } from "../spacing";
import type { View } from "../view";
import { FLIGHT } from "./flight";
import { areSame, nearer, type Orbit, type Reach, slid, turned } from "./orbit";
import { Sight } from "./sight";
import type { BodySizes } from "./sizes";
import { audienceSeat, type Box, overPlan, overview } from "./viewpoints";

/** From a body to the eye at the nearest, in heights of a figure. */
const NEAREST = 3;
/** From the whole stage to the eye at the farthest, in distances that show it. */
const FARTHEST = 3;

/** Ground that is seen around the agents, as a share of their extent. */
const ROOM_AROUND = 0.1;

/** The person's eye in the perspective view: it is flown and steered, and tells where it is. */
export interface Eye {
  readonly orbit: ReadonlySignal<Orbit>;
  /** As the orbit sees now; outside of effects. */
  sight(): Sight;
  turn(azimuth: number, elevation: number): void;
  /** What was under `from` goes to `to`, CSS pixels. */
  slide(from: ScreenPoint, to: ScreenPoint): void;
  zoom(factor: number, at?: ScreenPoint): void;
  fit(): void;
  sitDown(): void;
  stop(): void;
}

/** An eye that takes off from where the plan is seen, and shows the whole show until the person moves it. */
export function createEye(
  scene: ReadonlySignal<Scene>,
  view: Pick<View, "camera" | "size">,
  sizes: ReadonlySignal<BodySizes>,
): Eye {
  const { size } = view;
  const orbit = signal(overPlan(view.camera.peek(), size.peek()));
  const flight = createGlide(orbit, FLIGHT, framesForMotion());
  const sight = new Sight();
  let isFitted = true;

  const box = computed<Box>(() => {
    const sheet = sheetOf(scene.value.stage);
    const content = contentOf(scene.value);
    return { ...(content ? roomy(content) : sheet), height: highestOf(scene.value) + sizes.value.tallest };
  });
  const reach = computed<Reach>(() => {
    const sheet = sheetOf(scene.value.stage);
    return {
      bounds: union(sheet, contentOf(scene.value) ?? sheet),
      nearest: NEAREST * sizes.value.figure,
      farthest: FARTHEST * overview({ ...sheet, height: 0 }, size.value).distance,
    };
  });

  function look(): Sight {
    sight.look(orbit.value, size.value);
    return sight;
  }

  function place(next: Orbit, isWhole = false): void {
    isFitted = isWhole;
    flight.stop();
    orbit.value = next;
  }

  function showAll(): void {
    isFitted = true;
    flight.to(overview(box.peek(), size.peek()));
  }

  let lastSize = size.peek();
  let goal = orbit.peek();
  const stopFollowing = effect(() => {
    const whole = overview(box.value, size.value);
    const isResized = size.value !== lastSize;
    lastSize = size.value;
    if (!isFitted || areSame(whole, goal)) return;
    goal = whole;
    if (!isResized) flight.to(whole);
    else place(whole, true);
  });

  return {
    orbit,
    sight: look,
    turn: (azimuth, elevation) => place(turned(orbit.peek(), azimuth, elevation)),
    slide(from, to) {
      const { x, y, distance } = orbit.peek();
      const [a, b] = [look().groundAt(from), look().groundAt(to)];
      if (!a || !b) return;
      // Toward the horizon a pixel is any number of meters.
      const [dx, dy] = [clamp(a[0] - b[0], -distance, distance), clamp(a[1] - b[1], -distance, distance)];
      if (Number.isFinite(x + y + dx + dy)) place(slid(orbit.peek(), dx, dy, reach.peek()));
    },
    zoom(factor, at) {
      const { x, y, distance } = orbit.peek();
      const about = at ? look().groundAt(at) : null;
      const isNear = about !== null && Math.hypot(about[0] - x, about[1] - y) < 2 * distance;
      place(nearer(orbit.peek(), factor, isNear ? about : [x, y], reach.peek()));
    },
    fit: showAll,
    sitDown() {
      isFitted = false;
      flight.to(audienceSeat(box.peek(), sheetOf(scene.peek().stage), size.peek()));
    },
    stop() {
      flight.stop();
      stopFollowing();
    },
  };
}

/** Where the highest agent of any keyframe is. */
function highestOf(scene: Scene): number {
  let highest = 0;
  for (const { positions } of mainTrack(scene).keyframes) {
    for (const height of positions.heights ?? []) highest = Math.max(highest, height);
  }
  return highest;
}

function roomy(content: Bounds): Bounds {
  return grown(content, ROOM_AROUND * Math.max(content.maxX - content.minX, content.maxY - content.minY));
}
