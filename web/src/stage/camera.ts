import type { Point } from "../document/formation";

/** Stage to screen: `screen = (x · scale + left, −y · scale + top)`, CSS pixels. */
export interface Camera {
  /** Pixels a meter. */
  readonly scale: number;
  /** Screen place of the stage's origin. */
  readonly left: number;
  readonly top: number;
}

/** A place on the stage element: CSS pixels from its upper left, y down. */
export interface ScreenPoint {
  readonly x: number;
  readonly y: number;
}

/** CSS pixels. */
export interface Size {
  readonly width: number;
  readonly height: number;
}

/** What is kept free at the edges, CSS pixels. */
export interface Padding {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
}

/** A rectangle on the stage: meters, y away from the audience. */
export interface Bounds {
  readonly minX: number;
  readonly minY: number;
  readonly maxX: number;
  readonly maxY: number;
}

/** Pixels a meter: nothing is drawn usefully beyond a hundred-kilometer stage or a millimeter of it. */
export const SCALE_LIMITS = { min: 0.002, max: 4000 } as const;

export function toScreen(camera: Camera, point: Point): ScreenPoint {
  return { x: point[0] * camera.scale + camera.left, y: camera.top - point[1] * camera.scale };
}

export function toStage(camera: Camera, at: ScreenPoint): Point {
  return [(at.x - camera.left) / camera.scale, (camera.top - at.y) / camera.scale];
}

/** The camera that shows `bounds` as large as it fits inside the padding, in its middle. */
export function fitting(bounds: Bounds, size: Size, padding: Padding): Camera {
  const width = Math.max(size.width - padding.left - padding.right, 1);
  const height = Math.max(size.height - padding.top - padding.bottom, 1);
  const across = Math.max(bounds.maxX - bounds.minX, 1e-3);
  const deep = Math.max(bounds.maxY - bounds.minY, 1e-3);
  const scale = clampScale(Math.min(width / across, height / deep));
  return {
    scale,
    left: padding.left + width / 2 - ((bounds.minX + bounds.maxX) / 2) * scale,
    top: padding.top + height / 2 + ((bounds.minY + bounds.maxY) / 2) * scale,
  };
}

/** Zooms so that what is under `at` stays under it. */
export function zoomedAt(camera: Camera, factor: number, at: ScreenPoint): Camera {
  const scale = clampScale(camera.scale * factor);
  const applied = scale / camera.scale;
  return {
    scale,
    left: at.x - (at.x - camera.left) * applied,
    top: at.y - (at.y - camera.top) * applied,
  };
}

export function pannedBy(camera: Camera, dx: number, dy: number): Camera {
  return { scale: camera.scale, left: camera.left + dx, top: camera.top + dy };
}

/** Moves the camera as little as it takes to leave at least `margin` pixels of `bounds` in sight, so that nobody gets lost. */
export function keptInSight(camera: Camera, bounds: Bounds, size: Size, margin: number): Camera {
  const start = camera.left + bounds.minX * camera.scale;
  const end = camera.left + bounds.maxX * camera.scale;
  const back = camera.top - bounds.maxY * camera.scale;
  const front = camera.top - bounds.minY * camera.scale;
  const dx = pushInto(start, end, size.width, margin);
  const dy = pushInto(back, front, size.height, margin);
  return dx === 0 && dy === 0 ? camera : pannedBy(camera, dx, dy);
}

/** The same middle of the stage in an element of another size. */
export function recentered(camera: Camera, from: Size, to: Size): Camera {
  return pannedBy(camera, (to.width - from.width) / 2, (to.height - from.height) / 2);
}

/** The camera `t` of the way between two: the zoom runs evenly to the eye, and a place in both views moves straight. */
export function between(from: Camera, to: Camera, t: number): Camera {
  if (t <= 0) return from;
  if (t >= 1) return to;
  const ratio = to.scale / from.scale;
  const scale = from.scale * ratio ** t;
  const progress = Math.abs(ratio - 1) < 1e-6 ? t : (scale - from.scale) / (to.scale - from.scale);
  return {
    scale,
    left: from.left + (to.left - from.left) * progress,
    top: from.top + (to.top - from.top) * progress,
  };
}

/** The smallest rectangle around x, y pairs, null when there are none. */
export function boundsOf(xy: ArrayLike<number>): Bounds | null {
  let minX = Number.POSITIVE_INFINITY;
  let minY = Number.POSITIVE_INFINITY;
  let maxX = Number.NEGATIVE_INFINITY;
  let maxY = Number.NEGATIVE_INFINITY;
  for (let k = 0; k + 1 < xy.length; k += 2) {
    const x = xy[k] ?? 0;
    const y = xy[k + 1] ?? 0;
    if (x < minX) minX = x;
    if (x > maxX) maxX = x;
    if (y < minY) minY = y;
    if (y > maxY) maxY = y;
  }
  return maxX >= minX ? { minX, minY, maxX, maxY } : null;
}

export function union(a: Bounds, b: Bounds): Bounds {
  return {
    minX: Math.min(a.minX, b.minX),
    minY: Math.min(a.minY, b.minY),
    maxX: Math.max(a.maxX, b.maxX),
    maxY: Math.max(a.maxY, b.maxY),
  };
}

export function grown(bounds: Bounds, by: number): Bounds {
  return { minX: bounds.minX - by, minY: bounds.minY - by, maxX: bounds.maxX + by, maxY: bounds.maxY + by };
}

function clampScale(scale: number): number {
  return Math.min(SCALE_LIMITS.max, Math.max(SCALE_LIMITS.min, scale));
}

function pushInto(start: number, end: number, extent: number, margin: number): number {
  if (end < margin) return margin - end;
  if (start > extent - margin) return extent - margin - start;
  return 0;
}
