import { match } from "./matching.mjs";
import { along, arc, block, line, moved, ring, scaled, star } from "./places.mjs";
import { Show } from "./show.mjs";

/** Eight steps to five yards: 22.5 inches. */
const STEP = 0.5715;
/** Two steps apart, as drill is mostly written. */
const INTERVAL = 2 * STEP;

const SECTIONS = [
  { name: "Face", count: 96, prefix: "F", color: "#2d48cc" },
  { name: "Left eye", count: 18, prefix: "L", color: "#1399e4" },
  { name: "Right eye", count: 18, prefix: "R", color: "#b98800" },
  { name: "Mouth", count: 68, prefix: "M", color: "#c64f36" },
];

/** Two hundred on a football field: a greeting, a smile, a wink, a star. */
export function fieldShow() {
  const faces = { smile: smile(), wink: wink() };
  const inOrder = { isInOrder: true };
  return new Show({
    title: "Half-time",
    grid: STEP / 4,
    stage: { width: 109.728, depth: 48.768, backdrop: "football-college", units: "steps" },
    minimumDistance: 0.57,
    sections: SECTIONS,
  })
    .keyframe({ name: "Hi", time: 0, hold: 2 }, nearestTo(faces.smile, hi()))
    .keyframe({ name: "Smile", time: 12, hold: 2, ...inOrder }, faces.smile)
    .keyframe({ name: "Wink", time: 19, hold: 2 }, faces.wink)
    .keyframe({ name: "Star", time: 31, hold: 2 }, nearestTo(faces.wink, twoStars()))
    .toScene();
}

/**
 * Sections take the places nearest to where they stand in another formation, whatever figure comes of it.
 *
 * Least squares over all keeps ways from crossing at one time: no two come nearer than 1/√2 of their least distance.
 */
function nearestTo(formation, places) {
  const taken = match(
    SECTIONS.flatMap(({ name }) => formation[name]),
    places,
  );
  let first = 0;
  return Object.fromEntries(
    SECTIONS.map(({ name, count }) => {
      first += count;
      return [name, taken.slice(first - count, first)];
    }),
  );
}

const EYE = scaled(ring(3.35, 18), 0.9, 1.15);

function smile() {
  const mouth = [...arc(9, 200, 340, 20), ...arc(10.3, 199, 341, 23), ...arc(11.6, 198, 342, 25)];
  return {
    Face: ring(17.6, 96),
    "Left eye": moved(EYE, -6, 5),
    "Right eye": moved(EYE, 6, 5),
    Mouth: moved(mouth, 0, 1.5),
  };
}

function wink() {
  const grin = [...arc(10.2, 200, 340, 22), ...arc(11.5, 199, 341, 26)];
  const tongue = moved(block(4, 5, 1.3), 1.4, -12.2);
  const lid = [...arc(4.2, 160, 20, 9), ...arc(3, 165, 15, 9)];
  return {
    Face: ring(17.6, 96),
    "Left eye": moved(lid, -6.3, 3),
    "Right eye": moved(EYE, 6, 5),
    Mouth: [...moved(grin, 0, 3.2), ...tongue],
  };
}

function twoStars() {
  return [
    ...along(star(5, 20, 9), 100, true),
    ...along(star(5, 13.6, 6.1), 68, true),
    ...ring(5, 21),
    ...ring(2.4, 11),
  ];
}

/** HI! in strokes three and four wide. */
function hi() {
  const column = (width, rows, x, y = 0) => moved(block(width, rows, INTERVAL), x * INTERVAL, y * INTERVAL);
  const serif = (x, y) => line([(x - 1) * INTERVAL, y * INTERVAL], [(x + 1) * INTERVAL, y * INTERVAL], 3);
  return [
    ...[column(3, 14, -15), column(3, 14, -6), column(6, 2, -10.5)],
    ...[column(4, 14, 3.5), serif(0, 6.5), serif(7, 6.5), serif(0, -6.5), serif(7, -6.5)],
    ...[column(3, 9, 14, 2.5), column(3, 3, 14, -5.5)],
  ].flat();
}
