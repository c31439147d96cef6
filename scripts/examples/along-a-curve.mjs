import { crowdShow, spread } from "./crowd.mjs";
import { block, moved } from "./places.mjs";

/** Over and under the middle of the stage: half the height of the wave and of its length, meters. */
const [RISE, REACH] = [13, 36];

/** After figure 6: a formation travels along a path, and is another one at its end. */
export function alongACurve() {
  return crowdShow({
    title: "Along a curve",
    stage: { width: 110, depth: 56 },
    groupCount: 5,
    seconds: 18,
    pictures: [
      { name: "Block", places: moved(block(12, 15, 1.2), -REACH, -RISE) },
      { name: "Arrow", places: moved(spread(ARROW, 180, 24), 0, RISE), way: { path: wave(-REACH, 0) } },
      { name: "Ring", places: moved(spread(RING, 180, 19), REACH, -RISE), way: { path: wave(0, REACH) } },
    ],
  });
}

const ARROW = '<path d="M 0 34 L 52 34 L 52 10 L 100 50 L 52 90 L 52 66 L 0 66 Z"/>';
const RING = '<circle cx="50" cy="50" r="38" fill="none" stroke="black" stroke-width="24"/>';

function wave(from, to) {
  return Array.from({ length: 17 }, (_, index) => {
    const x = from + ((to - from) * index) / 16;
    return [x, RISE * Math.cos((Math.PI * x) / REACH)].map((value) => Number(value.toFixed(2)));
  });
}
