// Areas as closed outlines in meters, and places spread evenly in them.

/** Whether a place lies in a closed outline (even-odd). */
function isWithin([x, y], outline) {
  let isIn = false;
  for (let k = 0, before = outline.length - 1; k < outline.length; before = k, k += 1) {
    const [[ax, ay], [bx, by]] = [outline[k], outline[before]];
    if (ay > y !== by > y && x < ((bx - ax) * (y - ay)) / (by - ay) + ax) isIn = !isIn;
  }
  return isIn;
}

/** Exactly `count` places on a triangular lattice within outlines that may overlap, as wide apart as they fit. */
export function fill(outlines, count) {
  const all = outlines.flat();
  const [low, high] = [0, 1]
    .map((axis) => all.map((place) => place[axis]))
    .reduce(
      ([least, most], values) => [
        [...least, Math.min(...values)],
        [...most, Math.max(...values)],
      ],
      [[], []],
    );
  const lattice = (spacing) => {
    const places = [];
    const height = (spacing * Math.sqrt(3)) / 2;
    for (let row = 0, y = low[1] + height / 2; y < high[1]; row += 1, y += height) {
      for (let x = low[0] + (row % 2 === 0 ? 0.25 : 0.75) * spacing; x < high[0]; x += spacing) {
        if (outlines.some((outline) => isWithin([x, y], outline))) places.push([x, y]);
      }
    }
    return places;
  };
  let [tight, wide] = [0.1, high[0] - low[0]];
  for (let step = 0; step < 50; step += 1) {
    const middle = (tight + wide) / 2;
    if (lattice(middle).length >= count) tight = middle;
    else wide = middle;
  }
  const places = lattice(tight);
  // What is over is left out evenly, so that no corner misses all of it.
  const over = places.length - count;
  return places.filter(
    (_, index) => Math.floor(((index + 1) * over) / places.length) === Math.floor((index * over) / places.length),
  );
}

/** A bar with round ends from one joint to the next: a limb. */
function limb([x0, y0], [x1, y1], from, to) {
  const along = Math.atan2(y1 - y0, x1 - x0);
  const cap = (x, y, radius, start) =>
    Array.from({ length: 9 }, (_, step) => {
      const angle = start + (Math.PI * step) / 8;
      return [x + radius * Math.cos(angle), y + radius * Math.sin(angle)];
    });
  return [...cap(x1, y1, to, along - Math.PI / 2), ...cap(x0, y0, from, along + Math.PI / 2)];
}

function disc(x, y, radius) {
  return Array.from({ length: 48 }, (_, step) => {
    const angle = (2 * Math.PI * step) / 48;
    return [x + radius * Math.cos(angle), y + radius * Math.sin(angle)];
  });
}

export function circles(centers, radius) {
  return centers.map(([x, y]) => disc(x, y, radius));
}

/** Somebody who runs to the right, about 50 m tall. */
export function runner() {
  return [
    disc(7.5, 20.5, 4.6),
    limb([3.5, 14], [-2.5, -2], 4.4, 3.8),
    // The arm in front, bent, and the one behind.
    limb([4.5, 12.5], [12, 5.5], 2.3, 2),
    limb([12, 5.5], [18.5, 10.5], 2, 1.7),
    limb([2, 12.5], [-8.5, 9.5], 2.3, 2),
    limb([-8.5, 9.5], [-11.5, 1.5], 2, 1.7),
    // The leg in front, knee high, and the one behind that has just pushed off.
    limb([-1.5, -3.5], [9.5, -7], 3.3, 2.7),
    limb([9.5, -7], [8, -19.5], 2.6, 1.9),
    limb([8, -20], [12, -21], 1.8, 1.5),
    limb([-2.5, -3.5], [-9.5, -13.5], 3.3, 2.6),
    limb([-9.5, -13.5], [-20, -16.5], 2.5, 1.9),
    limb([-20, -16.5], [-21.5, -13], 1.8, 1.4),
  ];
}
