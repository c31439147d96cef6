import { crowdShow, spread } from "./crowd.mjs";
import { block } from "./places.mjs";
import { body, drawn } from "./silhouettes.mjs";

/** After figure 4: monks before a temple line up, and all together are one who fights. */
export function martialArts() {
  const figure = (pose, width) => spread(drawn(body(pose)), 400, width);
  return crowdShow({
    title: "Martial arts",
    stage: { width: 70, depth: 52 },
    groupCount: 8,
    seconds: 8,
    pictures: [
      { name: "Ranks", places: block(25, 16, 1.5) },
      { name: "Horse stance", places: figure(HORSE_STANCE, 34) },
      { name: "Punch", places: figure(PUNCH, 38) },
      { name: "High kick", places: figure(KICK, 38) },
      { name: "Crane", places: figure(CRANE, 36) },
    ],
  });
}

/** Seen from the front, fists at the hips. */
const HORSE_STANCE = {
  head: [0, 88],
  chest: [0, 66],
  hip: [0, 42],
  shoulders: [
    [-10, 70],
    [10, 70],
  ],
  hips: [
    [-5, 40],
    [5, 40],
  ],
  arms: [
    [
      [-31, 60],
      [-21, 44],
    ],
    [
      [31, 60],
      [21, 44],
    ],
  ],
  legs: [
    [
      [-31, 35],
      [-33, 5],
      [-43, 3],
    ],
    [
      [31, 35],
      [33, 5],
      [43, 3],
    ],
  ],
};

/** A long step ahead, one fist far out, the other drawn back. */
const PUNCH = {
  head: [7, 88],
  chest: [2, 66],
  hip: [-3, 42],
  arms: [
    [
      [28, 70],
      [52, 71],
    ],
    [
      [-21, 56],
      [-8, 46],
    ],
  ],
  legs: [
    [
      [26, 36],
      [25, 5],
      [37, 3],
    ],
    [
      [-24, 24],
      [-45, 5],
      [-35, 3],
    ],
  ],
};

/** On one leg, the other stretched above the head's height, the arms for balance. */
const KICK = {
  head: [-27, 84],
  chest: [-15, 66],
  hip: [-3, 47],
  arms: [
    [
      [8, 72],
      [20, 62],
    ],
    [
      [-36, 60],
      [-48, 46],
    ],
  ],
  legs: [
    [
      [21, 66],
      [44, 86],
      [51, 94],
    ],
    [
      [-1, 24],
      [-5, 5],
      [7, 3],
    ],
  ],
};

/** On one leg, the other knee drawn up, both arms as wings. */
const CRANE = {
  head: [0, 92],
  chest: [0, 70],
  hip: [0, 47],
  shoulders: [
    [-8, 74],
    [8, 74],
  ],
  arms: [
    [
      [-26, 87],
      [-46, 74],
    ],
    [
      [26, 87],
      [46, 74],
    ],
  ],
  legs: [
    [
      [22, 54],
      [17, 30],
      [27, 24],
    ],
    [
      [-1, 24],
      [-3, 5],
      [9, 3],
    ],
  ],
};
