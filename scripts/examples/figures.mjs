import { arc, block, line, moved, ring, turned } from "./places.mjs";
import { Show } from "./show.mjs";

// Small scenes after the figures of the spectral method's paper (Takahashi et al. 2009): one idea each.

const PALETTE = ["#c64f36", "#2d48cc", "#b98800", "#024b3b", "#e85fa8", "#1399e4", "#620687", "#07875b", "#4c5600"];
const STAGE = { width: 30, depth: 20 };

/** After figure 3: the same arrangement, turned. Straight ways shrink it; polar ways turn it as one. */
export function rotatedCopy() {
  const shape = [
    [-7, -0.5],
    [-4.5, 1.5],
    [-2, 3.5],
    [0.5, 1.5],
    [3, 3],
    [6.5, 1],
    [3.5, -1],
    [0.5, -3.5],
    [-3, -2.5],
  ];
  const middle = [0, 1].map((axis) => shape.reduce((sum, place) => sum + place[axis], 0) / shape.length);
  const source = moved(shape, -middle[0], -middle[1]);
  const everyone = { name: "everyone", count: shape.length, colors: PALETTE, isLoose: true };
  return new Show({ title: "Rotated copy", stage: STAGE, minimumDistance: 0.5, sections: [everyone] })
    .keyframe({ name: "Start", time: 0, hold: 1 }, { everyone: source })
    .keyframe({ name: "Turned", time: 6, hold: 1, isInOrder: true }, { everyone: turned(source, 150) })
    .keyframe({ name: "Start again", time: 12, hold: 1, isInOrder: true }, { everyone: source })
    .toScene([
      { kind: "transition", method: "linear" },
      { kind: "transition", method: "spectral" },
    ]);
}

/** After figure 4: not quite the same arrangement. Without the alignment some turn the wrong way around. */
export function aligned() {
  const source = ring(6, 6, 90).map(([x, y], index) => [x * 1.3, y * (index % 2 === 0 ? 0.75 : 0.6)]);
  const target = turned(source, 115).map(([x, y], index) => [
    x + [0.5, -1, 1, 0, -0.5, 0][index],
    y + [1, 0, -0.5, -1, 0.5, 0][index],
  ]);
  const everyone = { name: "everyone", count: 6, colors: PALETTE.slice(0, 6), isLoose: true };
  const spectral = { kind: "transition", method: "spectral", sharing: 0 };
  return new Show({ title: "With and without alignment", stage: STAGE, minimumDistance: 0.5, sections: [everyone] })
    .keyframe({ name: "Start", time: 0, hold: 1 }, { everyone: source })
    .keyframe({ name: "Not aligned", time: 6, hold: 1, isInOrder: true }, { everyone: target })
    .keyframe({ name: "Start again", time: 12, hold: 1, isInOrder: true }, { everyone: source })
    .keyframe({ name: "Aligned", time: 18, hold: 1, isInOrder: true }, { everyone: target })
    .toScene([{ ...spectral, alignment: "none" }, spectral, { ...spectral, alignment: "pca" }]);
}

/** After figure 6: four about one pass a gate; ties of ten keep them together. */
export function fourAroundOne() {
  const plus = [[0, 0], ...ring(2.2, 4, 90)];
  const gate = [...line([-1.6, 3.6], [-1.6, 8.4], 4), ...line([1.6, 3.6], [1.6, 8.4], 4)];
  const walls = [...gate, ...gate.map(([x, y]) => [x, -y])];
  const sections = [
    { name: "Five", count: 5, prefix: "F" },
    { name: "Gate", count: 16, prefix: "G", color: "#1d2a3a" },
  ];
  const ties = [1, 2, 3, 4].map((agent) => [0, agent, 10]);
  return new Show({
    title: "Four around one",
    stage: STAGE,
    minimumDistance: 0.5,
    adjacency: { ties },
    sections,
  })
    .keyframe({ name: "Before the gate", time: 0, hold: 1 }, { Five: moved(plus, -10, 0), Gate: walls })
    .keyframe(
      { name: "Behind it", time: 8, hold: 1, isInOrder: true },
      { Five: moved(turned(plus, 90), 10, 0), Gate: walls },
    )
    .toScene([{ kind: "transition", method: "spectral" }]);
}

export function threeBlocks() {
  const twelve = block(4, 3, 1.5);
  const sections = ["Left", "Middle", "Right"].map((name) => ({ name, count: 12, prefix: name[0], tieWeight: 10 }));
  const at = (angle) => arc(6.5, angle, angle, 1)[0];
  return new Show({ title: "Three blocks changing places", stage: STAGE, minimumDistance: 0.7, sections })
    .keyframe(
      { name: "In a row", time: 0, hold: 1 },
      { Left: moved(twelve, -9, 0), Middle: twelve, Right: moved(twelve, 9, 0) },
    )
    .keyframe(
      { name: "Triangle", time: 7, hold: 1, isInOrder: true },
      {
        Left: moved(twelve, ...at(210)),
        Middle: moved(twelve, ...at(90)),
        Right: moved(twelve, ...at(330)),
      },
    )
    .keyframe(
      { name: "All changed", time: 14, hold: 1, isInOrder: true },
      { Left: twelve, Middle: moved(twelve, 9, 0), Right: moved(twelve, -9, 0) },
    )
    .toScene();
}

/** A square in four arms about its middle, and the ring they open to. */
export function gridToRing() {
  // Four by three, above the middle and to its right: four quarter turns tile the square of 7 × 7 but its middle.
  const arm = moved(block(4, 3, 1.6), 2.4, 3.2);
  const arms = ["North", "West", "South", "East"];
  const sections = [
    ...arms.map((name) => ({ name, count: 12, prefix: name[0] })),
    { name: "middle", count: 1, isLoose: true },
  ];
  const grid = { middle: [[0, 0]] };
  const diamond = { middle: [[0, 0]] };
  const around = { middle: [[0, 0]] };
  for (const [index, name] of arms.entries()) {
    grid[name] = turned(arm, 90 * index);
    diamond[name] = turned(grid[name], 45);
    around[name] = arc(9, 90 * index + 11.25, 90 * index + 93.75, 12);
  }
  return new Show({ title: "Grid to ring", stage: { width: 40, depth: 26 }, minimumDistance: 0.7, sections })
    .keyframe({ name: "Grid", time: 0, hold: 1 }, grid)
    .keyframe({ name: "Ring", time: 7, hold: 1 }, around)
    .keyframe({ name: "Diamond", time: 14, hold: 1 }, diamond)
    .toScene();
}
