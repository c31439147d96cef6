import { block, moved, ring, turned } from "./places.mjs";
import { Show } from "./show.mjs";

// After figures of "Spectral-Based Group Formation Control" (2009): one change of formation, made twice in two ways.

const COLORS = ["#c64f36", "#2d48cc", "#b98800", "#024b3b", "#e85fa8", "#1399e4", "#620687", "#07875b", "#4c5600"];
const STAGE = { width: 30, depth: 20 };
/** The paper's own setting, beside what a figure varies. */
const SPECTRAL = { kind: "transition", method: "spectral", order: "greedy", alignment: "pca", sharing: 0 };
const LINEAR = { kind: "transition", method: "linear" };
const POLAR = { kind: "transition", method: "polar", alignment: "pca" };

/** From one formation to another and back and once more: the first way as in the figure's left, the last as in its right. */
function twice({ title, minimumDistance = 0.5, from, to, names, ways }) {
  const everyone = { name: "everyone", count: from.length, colors: COLORS.slice(0, from.length), isLoose: true };
  const inOrder = { hold: 1, isInOrder: true };
  return new Show({ title, stage: STAGE, minimumDistance, sections: [everyone] })
    .keyframe({ name: "Start", time: 0, hold: 1 }, { everyone: from })
    .keyframe({ name: names[0], time: 6, ...inOrder }, { everyone: to })
    .keyframe({ name: "Start again", time: 12, ...inOrder }, { everyone: from })
    .keyframe({ name: names[1], time: 18, ...inOrder }, { everyone: to })
    .toScene([ways[0], SPECTRAL, ways[1]]);
}

/** Figure 3: the same arrangement, turned. Straight ways shrink it, polar ways turn it as one. */
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
  const from = moved(shape, -middle[0], -middle[1]);
  return twice({
    title: "Rotated copy",
    minimumDistance: 1,
    from,
    to: turned(from, 150),
    names: ["Straight", "Turned as one"],
    ways: [LINEAR, POLAR],
  });
}

/** Figure 4: not quite the same arrangement, turned. Without the alignment some go the other way around. */
export function aligned() {
  return twice({
    title: "With and without alignment",
    from: [
      [-6, 1],
      [-2.5, 3.2],
      [2, 2.4],
      [6, 0.4],
      [2.2, -2.6],
      [-2.8, -2.2],
    ],
    to: [
      [3.55, -4.35],
      [-1.05, -4.2],
      [-2.35, 0.5],
      [-4.8, 3.95],
      [0.5, 4],
      [3.7, -0.05],
    ],
    names: ["Not aligned", "Aligned"],
    ways: [{ ...SPECTRAL, alignment: "none" }, SPECTRAL],
  });
}

/** Figure 5: who passes the middle winds about it in polar coordinates, and keeps with the others in modes. */
export function polarOrSpectral() {
  return twice({
    title: "Polar or spectral",
    from: [
      [-5.75, -0.25],
      [-1.75, 2],
      [6.75, -4],
      [1.25, 1.75],
      [4, -0.5],
      [-2, -1.25],
      [2.25, 4.5],
      [1.25, -1.25],
    ],
    to: [
      [-6, 3.5],
      [-1.5, 4],
      [6.5, -5.5],
      [0, -1.25],
      [5.5, -1],
      [-4.5, 2],
      [5, 3.5],
      [3, -1.75],
    ],
    names: ["Polar", "Spectral"],
    ways: [POLAR, SPECTRAL],
  });
}

/** Figure 6: four turn about one among others who stand. First as they happen to stand, then tied by ten. */
export function fourAroundOne() {
  const plus = [[0, 0], ...ring(2.4, 4)];
  const others = ring(8, 12, 105).map(([x, y]) => [x * 1.35, y]);
  const before = { Five: moved(plus, -3, -2), Others: others };
  const after = { Five: moved(turned(plus, 135), 3, 2), Others: others };
  const sections = [
    { name: "Five", count: 5, prefix: "F" },
    { name: "Others", count: 12, prefix: "O", isLoose: true },
  ];
  const ties = [1, 2, 3, 4].map((agent) => [0, agent, 10]);
  const loose = {};
  return new Show({ title: "Four around one", stage: STAGE, minimumDistance: 0.5, adjacency: { ties }, sections })
    .keyframe({ name: "Loose", time: 0, hold: 1, adjacency: loose }, before)
    .keyframe({ name: "Came apart", time: 7, hold: 1, adjacency: loose, isInOrder: true }, after)
    .keyframe({ name: "Tied", time: 14, hold: 1, isInOrder: true }, before)
    .keyframe({ name: "Kept together", time: 21, hold: 1, isInOrder: true }, after)
    .toScene(["spectral", "auto", "spectral"].map((method) => ({ kind: "transition", method })));
}

const NINE = [
  [-4.5, 3.25],
  [-2.75, -3.5],
  [4, 3.5],
  [-1, 4.25],
  [6, -0.75],
  [4.25, -4],
  [7, 2.25],
  [2.25, 1.75],
  [1.25, -1.5],
];
const NINE_MOVED = [
  [-4.25, 2.5],
  [-1, -1.25],
  [1.5, 3.25],
  [-5, 6],
  [7, -0.25],
  [3, -4.75],
  [5.75, 5],
  [-1, 5.25],
  [3.5, -2],
];

/** Figure 7: after a small change every mode finds itself again; after a large one their eigenvalues have changed places. */
export function smallAndLarge() {
  const everyone = { name: "everyone", count: NINE.length, colors: COLORS, isLoose: true };
  const slightly = NINE.map(([x, y], index) => [
    x + 0.12 * (NINE_MOVED[index][0] - x),
    y + 0.12 * (NINE_MOVED[index][1] - y),
  ]);
  const inOrder = { hold: 1, isInOrder: true };
  return new Show({ title: "A small and a large change", stage: STAGE, minimumDistance: 0.5, sections: [everyone] })
    .keyframe({ name: "Start", time: 0, hold: 1 }, { everyone: NINE })
    .keyframe({ name: "Small change", time: 5, ...inOrder }, { everyone: slightly })
    .keyframe({ name: "Large change", time: 11, ...inOrder }, { everyone: NINE_MOVED })
    .toScene([{ ...SPECTRAL, order: "eigenvalue" }, SPECTRAL]);
}

/** Figure 8: paired by eigenvalue, modes that have little in common turn into each other, and the paths wind. */
export function winding() {
  return twice({
    title: "Winding and smooth",
    from: NINE,
    to: NINE_MOVED,
    names: ["By eigenvalue", "By likeness"],
    ways: [{ ...SPECTRAL, order: "eigenvalue" }, SPECTRAL],
  });
}

/** How far four clusters turn as they pass each other; degrees. */
const CLUSTERS_TURN = 150;

/** Figure 9: clusters that pass each other. Straight ways run them through one another, spectral ways keep them whole. */
export function clusters() {
  return passing("Clusters passing", {});
}

/** The same with every pair kept apart: the straight ways bend, the spectral ones need not. */
export function clustersApart() {
  return passing("Clusters kept apart", { avoidance: true });
}

function passing(title, options) {
  const six = block(3, 2, 1.2);
  const names = ["North", "West", "South", "East"];
  const sections = names.map((name) => ({ name, count: 6, prefix: name[0], tieWeight: 4 }));
  const around = (radius, start, own) =>
    Object.fromEntries(
      names.map((name, index) => {
        const [[x, y]] = turned([[0, radius]], 90 * index + start);
        return [name, moved(turned(six, own + 30 * index), x, y)];
      }),
    );
  const before = around(6.2, 20, 0);
  const after = around(5.2, 20 + CLUSTERS_TURN, CLUSTERS_TURN);
  const inOrder = { hold: 1, isInOrder: true };
  return new Show({ title, stage: STAGE, minimumDistance: 0.5, sections })
    .keyframe({ name: "Start", time: 0, hold: 1 }, before)
    .keyframe({ name: "Straight", time: 7, ...inOrder }, after)
    .keyframe({ name: "Start again", time: 14, ...inOrder }, before)
    .keyframe({ name: "Spectral", time: 21, ...inOrder }, after)
    .toScene([LINEAR, SPECTRAL, SPECTRAL].map((way) => ({ ...way, ...options })));
}

/** Figure 2: six with nine ties of one weight, for a look at their modes. */
export function sixModes() {
  const everyone = { name: "everyone", count: 6, colors: COLORS.slice(0, 6), isLoose: true };
  const places = [
    [-6, 2.5],
    [-5, -2.5],
    [-1.5, 0.5],
    [2, -1],
    [6, 2.5],
    [6.5, -2.5],
  ];
  const ties = [
    [0, 1, 1],
    [0, 2, 1],
    [1, 2, 1],
    [2, 3, 1],
    [3, 4, 1],
    [3, 5, 1],
    [4, 5, 1],
    [0, 4, 1],
    [2, 4, 1],
  ];
  const adjacency = { base: "none", weights: "unit", ties };
  const after = turned(places, 70).map(([x, y]) => [x * 0.9, y * 1.1]);
  return new Show({ title: "Six and their modes", stage: STAGE, minimumDistance: 0.5, adjacency, sections: [everyone] })
    .keyframe({ name: "Six", time: 0, hold: 1 }, { everyone: places })
    .keyframe({ name: "Turned", time: 6, hold: 1, isInOrder: true }, { everyone: after })
    .toScene([SPECTRAL]);
}
