import type { Choice, Segment, Track } from "./scene";
import { stretchesOf } from "./stretches";

/**
 * The track with all parts of a transition as its first is, and no in-between at its ends. What auto took is forgotten
 * where one of the parts has forgotten it.
 */
export function withAlikeParts(changed: Track): Track {
  const track = withEnds(changed);
  const { anchors } = stretchesOf(track);
  if (anchors.length === track.keyframes.length) return track;
  const segments = anchors.slice(1).flatMap((to, index) => alike(track.segments.slice(anchors[index], to)));
  return segments.every((segment, index) => segment === track.segments[index]) ? track : { ...track, segments };
}

function withEnds(track: Track): Track {
  const last = track.keyframes.length - 1;
  const isEnd = (index: number) => index === 0 || index === last;
  if (![0, last].some((end) => (track.keyframes[end]?.between ?? 0) > 0)) return track;
  const keyframes = track.keyframes.map((was, index) =>
    isEnd(index) && was.between > 0 ? { ...was, between: 0 } : was,
  );
  return { ...track, keyframes };
}

function alike(parts: readonly Segment[]): readonly Segment[] {
  const [first] = parts;
  if (!first) return parts;
  const chosen = parts.every((part) => isSame(part.chosen, first.chosen)) ? first.chosen : null;
  const model = { ...first, chosen };
  // Each part is its own: selections follow a part by which object it is.
  return parts.map((part) => (isEqual(part, model) ? part : { ...model }));
}

function isSame(a: Choice | null, b: Choice | null): boolean {
  return a === b || (a !== null && b !== null && isEqual(a, b));
}

function isEqual<T extends object>(a: T, b: T): boolean {
  return Object.entries(b).every(([key, value]) => a[key as keyof T] === value);
}
