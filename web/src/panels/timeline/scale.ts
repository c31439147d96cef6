/** Time along the timeline: `x = origin + time · pixelsPerSecond`, CSS pixels from the left end of the track. */
export interface Scale {
  readonly origin: number;
  readonly pixelsPerSecond: number;
}

/** A thumbnail is this wide, centered on its keyframe's time. */
export const THUMBNAIL_WIDTH = 76;

/** What a ribbon between two thumbnails needs to show its shape and its label. */
const RIBBON_ROOM = 108;
const LEAST_ZOOM = 0.5;
const MOST_ZOOM = 400;
/** A scene of one keyframe shows about a minute of room. */
const EMPTY_ZOOM = 22;
/** Short shows are not stretched beyond this, so that there is room to go on. */
const MOST_FITTED_ZOOM = 120;

/** Where time 0 stands, and how much room stays free after the end. */
export interface Margins {
  readonly lead: number;
  readonly tail: number;
}

export function xOf(scale: Scale, time: number): number {
  return scale.origin + time * scale.pixelsPerSecond;
}

export function timeAt(scale: Scale, x: number): number {
  return (x - scale.origin) / scale.pixelsPerSecond;
}

export function clampZoom(pixelsPerSecond: number): number {
  return Math.min(MOST_ZOOM, Math.max(LEAST_ZOOM, pixelsPerSecond));
}

/**
 * The zoom a person meets first: the whole show where its keyframes stay legible, else such that the typical
 * interval shows its ribbon.
 *
 * @param intervals seconds from leaving each keyframe to arriving at the next
 */
export function fittedZoom(intervals: readonly number[], duration: number, width: number, margins: Margins): number {
  if (duration <= 0 || width <= 0) return EMPTY_ZOOM;
  const fits = (width - margins.lead - margins.tail) / duration;
  const typical = [...intervals].sort((a, b) => a - b)[intervals.length >> 1] ?? duration;
  const legible = (THUMBNAIL_WIDTH + RIBBON_ROOM) / typical;
  return clampZoom(fits < legible ? legible : Math.min(fits, MOST_FITTED_ZOOM));
}

/** How wide the track is: the whole show with its margins, never narrower than its window. */
export function trackWidth(scale: Scale, duration: number, width: number, margins: Margins): number {
  return Math.max(width, xOf(scale, duration) + margins.tail);
}

/** The scroll that keeps the time under the pointer in place while the zoom changes. */
export function scrollAfterZoom(before: Scale, after: Scale, scroll: number, pointer: number): number {
  return xOf(after, timeAt(before, scroll + pointer)) - pointer;
}

/** The scroll that shows `x`: unchanged while it is in the window, else a page that starts just before it. */
export function scrollToReveal(x: number, scroll: number, width: number): number {
  const edge = Math.min(60, width / 6);
  if (x >= scroll + edge / 2 && x <= scroll + width - edge / 2) return scroll;
  return x < scroll ? x - width + edge * 2 : x - edge;
}
