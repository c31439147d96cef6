// Places by rule: every function answers a list of [x, y] in meters, x to the right, y away from the audience.

const TURN = 2 * Math.PI;

/** Degrees to radians; 0 points right, 90 away from the audience. */
export function degrees(angle) {
  return (angle * Math.PI) / 180;
}

export function moved(places, dx, dy) {
  return places.map(([x, y]) => [x + dx, y + dy]);
}

/** Turned about the origin, counterclockwise. */
export function turned(places, angle) {
  const [c, s] = [Math.cos(degrees(angle)), Math.sin(degrees(angle))];
  return places.map(([x, y]) => [c * x - s * y, s * x + c * y]);
}

export function scaled(places, across, up = across) {
  return places.map(([x, y]) => [x * across, y * up]);
}

/** Rows from the back to the front, centered on the origin. */
export function block(columns, rows, spacing, rowSpacing = spacing) {
  const places = [];
  for (let row = 0; row < rows; row += 1) {
    for (let column = 0; column < columns; column += 1) {
      places.push([(column - (columns - 1) / 2) * spacing, ((rows - 1) / 2 - row) * rowSpacing]);
    }
  }
  return places;
}

export function line([x0, y0], [x1, y1], count) {
  return Array.from({ length: count }, (_, index) => {
    const t = count === 1 ? 0.5 : index / (count - 1);
    return [x0 + (x1 - x0) * t, y0 + (y1 - y0) * t];
  });
}

/** From one angle to the other, both ends included. */
export function arc(radius, from, to, count) {
  return Array.from({ length: count }, (_, index) => {
    const angle = degrees(from + (to - from) * (count === 1 ? 0.5 : index / (count - 1)));
    return [radius * Math.cos(angle), radius * Math.sin(angle)];
  });
}

export function ring(radius, count, start = 90) {
  return Array.from({ length: count }, (_, index) => {
    const angle = degrees(start) + (index / count) * TURN;
    return [radius * Math.cos(angle), radius * Math.sin(angle)];
  });
}

/** Circles between two radii that hold `count` in all, evenly spaced as far as whole numbers allow. */
export function annulus(inner, outer, circles, count) {
  const radii = line([inner, 0], [outer, 0], circles).map(([radius]) => radius);
  const whole = radii.reduce((sum, radius) => sum + radius, 0);
  const counts = radii.map((radius) => Math.floor((count * radius) / whole));
  for (let missing = count - counts.reduce((sum, each) => sum + each, 0); missing > 0; missing -= 1) {
    counts[counts.length - missing] += 1;
  }
  return radii.flatMap((radius, index) => ring(radius, counts[index], 90 + index * 7));
}

/** Evenly along a curve given by its points; closed curves come back to where they start. */
export function along(points, count, isClosed = false) {
  const path = isClosed ? [...points, points[0]] : points;
  const lengths = [0];
  for (let index = 1; index < path.length; index += 1) {
    const [a, b] = [path[index - 1], path[index]];
    lengths.push(lengths[index - 1] + Math.hypot(b[0] - a[0], b[1] - a[1]));
  }
  const total = lengths[lengths.length - 1];
  const places = [];
  let leg = 1;
  for (let index = 0; index < count; index += 1) {
    const at = (total * index) / (isClosed ? count : count - 1);
    while (leg < path.length - 1 && lengths[leg] < at) leg += 1;
    const t = (at - lengths[leg - 1]) / (lengths[leg] - lengths[leg - 1]);
    const [a, b] = [path[leg - 1], path[leg]];
    places.push([a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t]);
  }
  return places;
}

/** Corners of a star, the first straight up. */
export function star(points, outer, inner) {
  return Array.from({ length: 2 * points }, (_, index) => {
    const angle = degrees(90) + (index / (2 * points)) * TURN;
    const radius = index % 2 === 0 ? outer : inner;
    return [radius * Math.cos(angle), radius * Math.sin(angle)];
  });
}

/**
 * Exactly `count` places in rows about the y axis, each from edge to edge, so that the outline is crisp.
 *
 * @param {(y: number, spacing: number) => number} halfWidth of the area at y; negative where there is none
 */
export function rowsWithin(halfWidth, from, to, count) {
  let [tight, wide] = [0.05, to - from];
  for (let step = 0; step < 60; step += 1) {
    const middle = (tight + wide) / 2;
    if (sizeOf(rowCounts(halfWidth, from, to, middle)) >= count) tight = middle;
    else wide = middle;
  }
  const rows = rowCounts(halfWidth, from, to, tight);
  // The longest rows spare one each, where it shows least.
  const longest = [...rows].sort((a, b) => b.count - a.count);
  for (let over = sizeOf(rows) - count; over > 0; over -= 1) longest[over % longest.length].count -= 1;
  return rows.flatMap((row) => line([-row.half, row.y], [row.half, row.y], row.count));
}

function rowCounts(halfWidth, from, to, spacing) {
  const height = (spacing * Math.sqrt(3)) / 2;
  const rows = [];
  for (let y = from; y <= to; y += height) {
    const half = halfWidth(y, spacing);
    if (half >= 0) rows.push({ y, half, count: Math.floor((2 * half) / spacing) + 1 });
  }
  return rows;
}

function sizeOf(rows) {
  return rows.reduce((sum, row) => sum + row.count, 0);
}

/** Smallest distance of any two. */
export function leastDistance(places) {
  const sorted = [...places].sort((a, b) => a[0] - b[0]);
  let least = Number.POSITIVE_INFINITY;
  for (let i = 0; i < sorted.length; i += 1) {
    for (let j = i + 1; j < sorted.length && sorted[j][0] - sorted[i][0] < least; j += 1) {
      least = Math.min(least, Math.hypot(sorted[j][0] - sorted[i][0], sorted[j][1] - sorted[i][1]));
    }
  }
  return least;
}
