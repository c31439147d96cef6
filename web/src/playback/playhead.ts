/** A stretch of the show, scene seconds. */
export interface Span {
  readonly from: number;
  readonly to: number;
}

/** Where the playhead came to, and whether it goes on. */
export interface Advance {
  readonly time: number;
  readonly isPlaying: boolean;
}

/** Where playing begins: the end starts over, and a loop is entered at its start from anywhere behind it. */
export function startFrom(time: number, span: Span, isLooping: boolean): number {
  if (span.to <= span.from) return span.from;
  const isPast = time >= span.to;
  const isBefore = isLooping && time < span.from;
  return isPast || isBefore ? span.from : Math.max(time, 0);
}

/** Moves the playhead by `elapsed` scene seconds: a loop comes round, however often; without one it stops at the end. */
export function advance(time: number, elapsed: number, span: Span, isLooping: boolean): Advance {
  const next = time + Math.max(elapsed, 0);
  if (next < span.to) return { time: next, isPlaying: true };
  const length = span.to - span.from;
  if (!isLooping || length <= 0) return { time: span.to, isPlaying: false };
  return { time: span.from + ((next - span.from) % length), isPlaying: true };
}

/** The part of `range` that the show has; the whole show when there is no range or nothing of it is left. */
export function playedSpan(range: Span | null, duration: number): Span {
  const whole = { from: 0, to: duration };
  if (!range) return whole;
  const from = within(Math.min(range.from, range.to), whole);
  const to = within(Math.max(range.from, range.to), whole);
  return to > from ? { from, to } : whole;
}

export function within(time: number, span: Span): number {
  if (Number.isNaN(time)) return span.from;
  return Math.min(span.to, Math.max(span.from, time));
}
