/** The area a plot is drawn in, and the values at its lower and upper edge. */
export interface PlotFrame {
  readonly width: number;
  readonly height: number;
  readonly low: number;
  readonly high: number;
}

/** Where a value is drawn: the upper edge is 0. */
export function plotY(frame: PlotFrame, value: number): number {
  const share = frame.high > frame.low ? (value - frame.low) / (frame.high - frame.low) : 0;
  return round(frame.height * (1 - Math.min(1, Math.max(0, share))));
}

/** Where sample `index` of `count` is drawn. */
export function plotX(frame: PlotFrame, index: number, count: number): number {
  return count > 1 ? round((frame.width * index) / (count - 1)) : 0;
}

/** SVG path data of a curve, no more points than two a pixel; of each step the sample that sticks out most is kept. */
export function curvePath(values: ArrayLike<number>, frame: PlotFrame): string {
  return kept(values, frame)
    .map(
      (index, place) =>
        `${place === 0 ? "M" : "L"}${plotX(frame, index, values.length)} ${plotY(frame, values[index] ?? 0)}`,
    )
    .join("");
}

/** The area between a curve and the lower edge. */
export function areaPath(values: ArrayLike<number>, frame: PlotFrame): string {
  if (values.length === 0) return "";
  return `${curvePath(values, frame)}L${frame.width} ${frame.height}L0 ${frame.height}Z`;
}

/** The stretches of a curve below `limit`, from where it crosses to where it crosses back. */
export function belowPath(values: ArrayLike<number>, frame: PlotFrame, limit: number): string {
  let path = "";
  let isOpen = false;
  for (let index = 0; index < values.length; index += 1) {
    const value = values[index] ?? 0;
    const before = values[index - 1];
    const isBelow = value < limit;
    if (before !== undefined && isBelow !== before < limit) {
      const x = plotX(frame, index - 1 + (limit - before) / (value - before), values.length);
      path += `${isBelow ? "M" : "L"}${x} ${plotY(frame, limit)}`;
    } else if (isBelow && !isOpen) {
      path += `M${plotX(frame, index, values.length)} ${plotY(frame, value)}`;
    }
    if (isBelow) path += `L${plotX(frame, index, values.length)} ${plotY(frame, value)}`;
    isOpen = isBelow;
  }
  return path;
}

function kept(values: ArrayLike<number>, frame: PlotFrame): number[] {
  const count = values.length;
  const most = Math.max(2, Math.round(frame.width * 2));
  if (count <= most) return Array.from({ length: count }, (_, index) => index);
  const indices: number[] = [0];
  for (let step = 1; step < most - 1; step += 1) {
    const from = 1 + Math.floor(((step - 1) * (count - 2)) / (most - 2));
    const to = 1 + Math.floor((step * (count - 2)) / (most - 2));
    const last = values[indices[indices.length - 1] ?? 0] ?? 0;
    let best = from;
    for (let index = from; index < to; index += 1) {
      if (Math.abs((values[index] ?? 0) - last) > Math.abs((values[best] ?? 0) - last)) best = index;
    }
    indices.push(best);
  }
  return [...indices, count - 1];
}

function round(value: number): number {
  return Math.round(value * 100) / 100;
}
