import { computed, effect, type ReadonlySignal, signal } from "@preact/signals";
import type { Scene } from "../document/scene";
import {
  type Bounds,
  between,
  type Camera,
  fitting,
  keptInSight,
  type Padding,
  pannedBy,
  recentered,
  SCALE_LIMITS,
  type Size,
  union,
  zoomedAt,
} from "./camera";
import { type Course, createGlide, framesForMotion } from "./glide";
import { contentOf, sheetOf } from "./sheet";
import { clamp } from "./spacing";
import type { Layers, Lens, Projection, View } from "./view";

const EVERYTHING: Layers = { ties: true, trails: true, ghosts: true, groups: true, names: true };

/** The tool rail, and the numbers of an axis beside it, the view and zoom pills and the context bar stay clear of what was fitted. */
const ROOM_FOR_PANELS: Padding = { left: 92, right: 24, top: 60, bottom: 80 };
/** A narrow stage has its tools below. */
const ROOM_ON_A_PHONE: Padding = { left: 16, right: 16, top: 20, bottom: 80 };
/** What was fitted stays clear of a sheet below it. */
const ROOM_OVER_A_SHEET = 16;
const NARROW = 640;

/** The whole stage is shown unless the show fills so little of it that going closer pays. */
const WORTH_GOING_CLOSER = 1.25;
const WORTH_IT_ON_A_PHONE = 1.02;

/** A disc that sticks out at the edge does not unsettle the view of the stage. */
const NEARLY_WHOLE = 0.97;

/** A lone agent does not fill the screen. */
const CLOSEST_FIT = 6;

/** Pixels of the stage that stay in sight however far it is panned. */
const IN_SIGHT = 48;

/** 3 % to 6,400 % of the whole stage. */
const ZOOM_RANGE = { min: 0.03, max: 64 } as const;

/** The look's slow motion, for sheets and the camera. */
const GLIDING: Course<Camera> = { duration: 280, at: (from, to, t) => between(from, to, 1 - (1 - t) ** 3) };

/** Looks at the stage of `scene`: it starts fitted and stays so through resizing until the person moves it. */
export function createView(scene: ReadonlySignal<Scene>, projection = signal<Projection>("plan")): View {
  const sheet = computed(() => sheetOf(scene.value.stage));
  const size = signal<Size>({ width: 0, height: 0 });
  const camera = signal<Camera>(fitting(sheet.peek(), { width: 800, height: 600 }, ROOM_FOR_PANELS));
  const covered = signal(0);
  const whole = computed(() => fitting(sheet.value, size.value, paddingFor(size.value)));
  const glide = createGlide(camera, GLIDING, framesForMotion());
  let isFitted = true;
  /** What is fitted instead of the whole show. */
  let shown: Bounds | null = null;
  let lastSize = size.peek();

  function place(next: Camera): void {
    isFitted = false;
    glide.stop();
    const all: Bounds = union(sheet.peek(), contentOf(scene.peek()) ?? sheet.peek());
    camera.value = keptInSight(next, all, size.peek(), IN_SIGHT);
  }

  function fitted(): Camera {
    const room = paddingFor(size.peek(), covered.peek());
    return shown ? fitting(shown, size.peek(), room) : fittedTo(scene.peek(), size.peek(), room);
  }

  effect(() => {
    const next = size.value;
    if (next.width === 0 || next.height === 0) return;
    glide.stop();
    camera.value = isFitted ? fitted() : recentered(camera.peek(), lastSize, next);
    lastSize = next;
  });

  effect(() => {
    void covered.value;
    if (isFitted && size.peek().width > 0) glide.to(fitted());
  });

  return {
    camera,
    covered,
    layers: signal(EVERYTHING),
    size,
    hovered: signal<number | null>(null),
    theme: signal<"light" | "dark" | "system">("system"),
    ruler: signal<"seconds" | "counts">("seconds"),
    projection,
    lens: signal<Lens | null>(null),
    zoom: computed(() => camera.value.scale / whole.value.scale),
    zoomBy(factor, at) {
      const middle = at ?? { x: size.peek().width / 2, y: size.peek().height / 2 };
      const unit = whole.peek().scale;
      const scale = clamp(
        camera.peek().scale * factor,
        Math.max(SCALE_LIMITS.min, unit * ZOOM_RANGE.min),
        Math.min(SCALE_LIMITS.max, unit * ZOOM_RANGE.max),
      );
      place(zoomedAt(camera.peek(), scale / camera.peek().scale, middle));
    },
    panBy(dx, dy) {
      place(pannedBy(camera.peek(), dx, dy));
    },
    fit() {
      isFitted = true;
      shown = null;
      if (size.peek().width > 0) glide.to(fitted());
    },
    show(bounds) {
      isFitted = true;
      shown = bounds;
      glide.stop();
      if (size.peek().width > 0) camera.value = fitted();
    },
  };
}

function fittedTo(scene: Scene, size: Size, padding: Padding): Camera {
  const content = contentOf(scene);
  const sheet = sheetOf(scene.stage);
  const whole = fitting(sheet, size, padding);
  if (!content) return whole;
  const close = fitting(content, size, padding);
  const closest = whole.scale * CLOSEST_FIT;
  if (close.scale > closest) {
    const middle = {
      x: (padding.left + size.width - padding.right) / 2,
      y: (padding.top + size.height - padding.bottom) / 2,
    };
    return zoomedAt(close, closest / close.scale, middle);
  }
  const isOutside = fitting(union(sheet, content), size, padding).scale < whole.scale * NEARLY_WHOLE;
  const worth = isNarrow(size) ? WORTH_IT_ON_A_PHONE : WORTH_GOING_CLOSER;
  return close.scale > whole.scale * worth || isOutside ? close : whole;
}

/** @param covered pixels from below */
function paddingFor(size: Size, covered = 0): Padding {
  const room = isNarrow(size) ? ROOM_ON_A_PHONE : ROOM_FOR_PANELS;
  return covered > 0 ? { ...room, bottom: Math.max(room.bottom, covered + ROOM_OVER_A_SHEET) } : room;
}

function isNarrow(size: Size): boolean {
  return size.width <= NARROW;
}
