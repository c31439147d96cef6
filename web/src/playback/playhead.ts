/** A stretch of the show, scene seconds. */
export interface Span {
  readonly from: number;
  readonly to: number;
}

/** Where playing begins: the end starts over, and a loop is entered at its start from anywhere behind it. */
export function startFrom(time: number, span: Span, isLooping: boolean): number {
  if (span.to <= span.from) return span.from;
  const isPast = time >= span.to;
  const isBefore = isLooping && time < span.from;
  return isPast || isBefore ? span.from : Math.max(time, 0);
}

/** Where `elapsed` scene seconds take the playhead: a loop comes round, however often; without one it stops at the end of `span`. */
export function advance(time: number, elapsed: number, span: Span, isLooping: boolean): number {
  const next = time + Math.max(elapsed, 0);
  if (next < span.to) return next;
  const length = span.to - span.from;
  return isLooping && length > 0 ? span.from + ((next - span.from) % length) : span.to;
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
