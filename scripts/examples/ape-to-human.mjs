import { crowdShow, spread } from "./crowd.mjs";
import { arc, moved, turned } from "./places.mjs";
import { body, drawn } from "./silhouettes.mjs";

/** Up a hill: the angles on its circle where they stand, degrees, and its radius, meters. */
const STATIONS = [122, 106, 90];
const RADIUS = 118;
/** From the middle of the stage to the middle of the circle, meters. */
const [ACROSS, DOWN] = [32, 108];

/** After figure 7: an ape rises and walks on as a human, along a curve. */
export function apeToHuman() {
  const poses = [
    ["Ape", APE, 31],
    ["Halfway", HALFWAY, 25],
    ["Human", HUMAN, 23.5],
  ];
  const pictures = poses.map(([name, pose, width], index) => {
    const lean = STATIONS[index] - 90;
    const [[x, y]] = arc(RADIUS, STATIONS[index], STATIONS[index], 1);
    const figure = centered(spread(drawn(body(pose)), 400, width));
    const before = STATIONS[index - 1];
    return {
      name,
      places: moved(turned(figure, lean), x + ACROSS, y - DOWN),
      ...(before && { turn: STATIONS[index] - before, way: { path: hill(before, STATIONS[index]) } }),
    };
  });
  return crowdShow({
    title: "From ape to human",
    stage: { width: 100, depth: 66 },
    groupCount: 6,
    seconds: 14,
    pictures,
  });
}

function hill(from, to) {
  return moved(arc(RADIUS, from, to, 13), ACROSS, -DOWN).map((place) => place.map((value) => Number(value.toFixed(2))));
}

/** About their barycenter. */
function centered(places) {
  const [x, y] = [0, 1].map((axis) => places.reduce((sum, place) => sum + place[axis], 0) / places.length);
  return moved(places, -x, -y);
}

/** On feet and knuckles. */
const APE = {
  head: [35, 60],
  chest: [14, 50],
  hip: [-22, 38],
  arms: [
    [
      [24, 27],
      [31, 4],
    ],
    [
      [8, 26],
      [3, 4],
    ],
  ],
  legs: [
    [
      [-11, 22],
      [-22, 4],
      [-12, 3],
    ],
    [
      [-32, 22],
      [-42, 4],
      [-32, 3],
    ],
  ],
};

/** On bent legs, long arms ahead. */
const HALFWAY = {
  head: [20, 77],
  chest: [8, 62],
  hip: [-7, 40],
  arms: [
    [
      [23, 46],
      [30, 28],
    ],
    [
      [-6, 46],
      [6, 26],
    ],
  ],
  legs: [
    [
      [8, 27],
      [4, 4],
      [15, 3],
    ],
    [
      [-10, 22],
      [-24, 5],
      [-14, 3],
    ],
  ],
};

/** Upright, in the middle of a step. */
const HUMAN = {
  head: [0, 95],
  chest: [-1, 71],
  hip: [0, 49],
  arms: [
    [
      [13, 57],
      [24, 44],
    ],
    [
      [-15, 57],
      [-21, 40],
    ],
  ],
  legs: [
    [
      [14, 28],
      [23, 5],
      [34, 4],
    ],
    [
      [-9, 27],
      [-25, 8],
      [-17, 2],
    ],
  ],
};
