import { match } from "./matching.mjs";
import { degrees, turned } from "./places.mjs";

const column = (x) => [0, 5 / 3, 10 / 3, 5].map((up) => [x, up]);
const E = [
  ...[0, 1.25, 2.5, 3.75, 5].map((up) => [0, up]),
  ...[5, 2.5, 0].map((up) => [1.6, up]),
  ...[5, 0].map((up) => [3.2, up]),
];
const D_BOW = [
  [1.5, 5],
  [2.9, 4.3],
  [3.5, 3.2],
  [3.5, 1.8],
  [2.9, 0.7],
  [1.5, 0],
];

/** Ten places each, across and up, in a cell about five high. */
const LETTERS = [
  ["T", [...[0, 1, 2, 3, 4].map((x) => [x, 5]), ...[4, 3, 2, 1, 0].map((up) => [2, up])]],
  ["H", [...column(0), ...column(4), [4 / 3, 2.5], [8 / 3, 2.5]]],
  ["E", E],
  ["E again", E],
  ["N", [...column(0), ...column(4), [4 / 3, 10 / 3], [8 / 3, 5 / 3]]],
  ["D", [...column(0), ...D_BOW]],
];

/** Meters of a cell's unit, and how high the feet of the letters are. */
const UNIT = 5;
const FEET = 15;
/** Letters lean back, so that they read from above and from the front, and turn this way and that; degrees. */
const LEAN = 45;
const TURN = 20;
const GRID = 0.05;

/** After figure 12: ten planes write THE END in the sky. */
export function airshow() {
  let before = null;
  const keyframes = LETTERS.map(([name, cells], index) => {
    const [left, right] = [0, 1].map((end) => (end === 0 ? Math.min : Math.max)(...cells.map(([x]) => x)));
    const upright = cells.map(([x, up]) => [(x - (left + right) / 2) * UNIT, up * UNIT]);
    const ordered = before ? match(before, upright) : upright;
    before = ordered;
    const [lean, turn] = [degrees(LEAN), index % 2 === 0 ? TURN : -TURN];
    const positions = ordered.map(([across, up]) => {
      const [ground] = turned([[across, (up - 2.5 * UNIT) * Math.cos(lean)]], turn);
      return [...ground, FEET + up * Math.sin(lean)].map(snapped);
    });
    return { name, time: 6 * index, hold: 1, positions };
  });
  return {
    format: "eigenform",
    version: 1,
    title: "The end",
    stage: { width: 60, depth: 40, height: 50 },
    minimumDistance: 2,
    agents: Array.from({ length: 10 }, (_, index) => ({ name: `${index + 1}`, color: COLORS[index % COLORS.length] })),
    keyframes,
    segments: LETTERS.slice(1).map(() => ({ kind: "transition", method: "spectral", alignment: "procrustes" })),
  };
}

const COLORS = ["#c64f36", "#2d48cc", "#b98800", "#024b3b", "#e85fa8", "#1399e4", "#620687", "#07875b", "#4c5600"];

function snapped(value) {
  const on = Number((Math.round(value / GRID) * GRID).toFixed(6));
  return on === 0 ? 0 : on;
}
