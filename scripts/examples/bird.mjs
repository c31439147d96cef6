import { brushed, crowdShow, spread } from "./crowd.mjs";

/** After figure 2: the character for "bird" in four hands, from a picture scratched into bone to the strokes of today. */
export function bird() {
  const drawn = (strokes) => spread(brushed(strokes, 6.5), 400, 42);
  return crowdShow({
    title: "Bird in four hands",
    stage: { width: 70, depth: 60 },
    groupCount: 8,
    seconds: 8,
    pictures: [
      { name: "Bone", places: drawn(BONE) },
      { name: "Bronze", places: drawn(BRONZE) },
      { name: "Brush", places: drawn(BRUSH) },
      { name: "Today", places: drawn(TODAY) },
    ],
  });
}

/** A bird seen from the side, as one scratches it: beak, body, wing, tail, claws. */
const BONE = [
  "M 34 14 C 46 8 56 16 53 30 C 66 36 80 52 92 78 L 74 70 C 62 78 42 74 36 58 C 31 46 34 36 31 28 C 27 22 28 17 34 14 Z",
  "M 29 20 L 10 26 L 31 31",
  "M 50 44 C 60 48 68 56 72 66",
  "M 46 74 L 42 92 L 28 92 M 42 92 L 54 94",
  "M 60 76 L 62 92",
];

/** The same cast in bronze: fewer lines, and the feathers sweep down. */
const BRONZE = [
  "M 40 10 C 24 10 20 28 34 34 C 48 40 60 30 54 18 C 51 12 46 10 40 10 Z",
  "M 26 18 L 8 20",
  "M 34 34 C 28 50 32 62 42 70",
  "M 54 32 C 70 40 84 58 92 84",
  "M 48 42 C 58 50 66 62 72 80",
  "M 42 50 C 48 58 54 68 56 80",
  "M 42 70 L 36 92 L 22 92 M 36 92 L 50 94",
];

/** Eleven strokes of a brush. */
const BRUSH = [
  "M 50 4 L 42 15",
  "M 28 16 L 28 68",
  "M 28 16 L 70 16 L 70 42",
  "M 28 29 L 70 29",
  "M 28 42 L 70 42",
  "M 28 55 L 84 55",
  "M 28 68 L 88 68 C 88 84 86 94 80 97 L 75 95",
  "M 15 80 L 9 94",
  "M 30 81 L 31 93",
  "M 44 80 L 48 91",
  "M 58 79 L 63 88",
];

/** Five strokes. */
const TODAY = [
  "M 50 4 L 42 18",
  "M 24 19 L 72 19 C 72 32 71 42 65 46 L 60 45",
  "M 39 29 L 46 39",
  "M 24 19 L 24 57 L 82 57 C 82 78 80 90 72 95 L 60 91",
  "M 10 75 L 64 75",
];
