import { placesIn } from "./engine.mjs";
import { match } from "./matching.mjs";
import { turned } from "./places.mjs";
import { Show } from "./show.mjs";
import { together } from "./together.mjs";

/** Least squared ways keep straight movers apart by what they stand apart over √2: a little more than the scene's distance. */
const APART = 0.85;
export const MINIMUM_DISTANCE = 0.5;
/** Seconds that a crowd stands in each picture. */
const HOLD = 1;
const COLORS = ["#c64f36", "#2d48cc", "#b98800", "#07875b", "#e85fa8", "#1399e4", "#620687", "#4c5600", "#024b3b"];

/**
 * A crowd that goes from picture to picture: everybody where the sum of squared ways is least, in groups of those who stay
 * together throughout, moved by social forces along straight ways.
 *
 * @param {{ pictures: { name: string, places: [number, number][], turn?: number, isInOrder?: boolean, way?: object }[] }} crowd
 *   `turn`: how far all wheel on the way there, degrees; `isInOrder`: the places are given by agent; `way`: what else the transition
 *   there is told; `groupedBy`: in how many of the pictures, from the first, groups stay together
 */
export function crowdShow({ pictures, groupCount, groupedBy = pictures.length, seconds, ...scene }) {
  let before = null;
  const formations = pictures.map(({ places, turn = 0, isInOrder = false }) => {
    before = before && !isInOrder ? match(turned(before, turn), places) : places;
    return before;
  });
  const count = formations[0].length;
  const groups = together(formations.slice(0, groupedBy), [...formations[0].keys()], [groupCount]);
  const sections = groups.map((agents, index) => ({
    name: `Group ${index + 1}`,
    count: agents.length,
    color: COLORS[index],
  }));
  const show = new Show({ minimumDistance: MINIMUM_DISTANCE, grid: 0.01, sections, ...scene });
  for (const [index, { name }] of pictures.entries()) {
    const places = groups.map((agents, group) => [
      `Group ${group + 1}`,
      agents.map((agent) => formations[index][agent]),
    ]);
    show.keyframe({ name, time: index * seconds, hold: HOLD, isInOrder: true }, Object.fromEntries(places));
  }
  if (count !== groups.flat().length) throw new Error(`${scene.title}: somebody is in no group`);
  return show.toScene(pictures.slice(1).map(({ way }) => ({ ...CROWD, ...way })));
}

/** Forces along straight ways, kept apart, and how it was found who goes where. */
const CROWD = { kind: "transition", method: "crowd", avoidance: true, assignment: { cost: "squared" } };

/** Places all over a drawing `width` meters wide, evenly. */
export function spread(drawing, count, width) {
  return placesIn(drawing, count, width, APART);
}

/** Strokes of a brush of one width in a square of 100. */
export function brushed(strokes, width) {
  const ends = 'stroke-linecap="round" stroke-linejoin="round"';
  return `<path d="${strokes.join(" ")}" fill="none" stroke="black" stroke-width="${width}" ${ends}/>`;
}
