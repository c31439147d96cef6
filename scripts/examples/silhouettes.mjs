// Bodies as closed outlines that may overlap: x to the right, y up.

/** Outlines as a drawing (SVG), filled, as large as a square of 100 holds. */
export function drawn(outlines) {
  const [left, right] = ends(outlines.flat().map(([x]) => x));
  const [bottom, top] = ends(outlines.flat().map(([, y]) => y));
  const scale = 100 / Math.max(right - left, top - bottom);
  const point = ([x, y]) => [(x - left) * scale, (top - y) * scale].map((value) => value.toFixed(2)).join(" ");
  return `<path d="${outlines.map((outline) => `M ${outline.map(point).join(" L ")} Z`).join(" ")}"/>`;
}

function ends(values) {
  return [Math.min(...values), Math.max(...values)];
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

/**
 * A body by its joints; `arms` are elbow and hand, `legs` knee, heel and toes, from the chest and from the hip.
 *
 * @param {{ head: [number, number], chest: [number, number], hip: [number, number], arms: [number, number][][], legs: [number, number][][] }} pose
 */
export function body({ head, chest, hip, arms, legs, shoulders = [chest, chest], hips = [hip, hip] }) {
  return [
    disc(...head, HEAD),
    limb(chest, hip, CHEST, HIP),
    ...arms.flatMap(([elbow, hand], side) => [
      limb(shoulders[side], elbow, SHOULDER, ELBOW),
      limb(elbow, hand, ELBOW, HAND),
    ]),
    ...legs.flatMap(([knee, heel, toes], side) => [
      limb(hips[side], knee, THIGH, KNEE),
      limb(knee, heel, KNEE, ANKLE),
      limb(heel, toes, ANKLE, TOES),
    ]),
  ];
}

// Half widths of somebody 100 tall.
const [HEAD, CHEST, HIP] = [9, 11, 9];
const [SHOULDER, ELBOW, HAND] = [5.5, 4.8, 4.4];
const [THIGH, KNEE, ANKLE, TOES] = [7.5, 6, 4.6, 3.6];
