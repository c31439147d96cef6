import { placesIn } from "./engine.mjs";
import { match } from "./matching.mjs";
import { moved, ring, star, turned } from "./places.mjs";
import { Show } from "./show.mjs";
import { drawn, runner } from "./silhouettes.mjs";
import { together } from "./together.mjs";

/** Meters from one to the next in every picture, about. */
const SPACING = 1.1;
/** A body in five parts, each of seven groups of six subgroups of six: 35 groups, 1,260 agents. */
const [PARTS, GROUPS, SUBGROUPS, MEMBERS] = [5, 7, 6, 6];
const SIZE = GROUPS * SUBGROUPS * MEMBERS;
const COUNT = PARTS * SIZE;
/** Two of a family for each part, in turn, so that groups stand out from their neighbors. */
const COLORS = [
  ["#c64f36", "#e85fa8"],
  ["#2d48cc", "#1399e4"],
  ["#b98800", "#4c5600"],
  ["#024b3b", "#07875b"],
  ["#620687", "#a45be0"],
];
/** How far all wheel on the way to the star, by one of its points; degrees. */
const WHEEL = 72;

/** After figure 11: a circle, a star, somebody who runs, five circles; in three levels of groups. */
export function thousand() {
  const runs = [
    [5, 26],
    [-14, 6],
    [-10, -20],
    [18, -22],
    [15, 0],
  ];
  const formations = chained([
    [0, divided(rings(1, 20), around(12, -WHEEL))],
    [WHEEL, divided(spread(drawn([star(5, 50, 21)]), 62), around(20))],
    [0, divided(spread(drawn(runner()), 60), runs)],
    [0, around(21).map((middle) => moved(rings(3, 9), ...middle))],
  ]);
  const tree = Array.from({ length: PARTS }, (_, part) => {
    const own = formations.map((parts) => parts[part]);
    return together(own, [...own[0].keys()], [GROUPS, SUBGROUPS]).map((group) =>
      group.map((members) => members.map((agent) => part * SIZE + agent)),
    );
  });
  const order = tree.flat(3);
  const show = new Show({
    title: "Twelve hundred and sixty",
    stage: { width: 100, depth: 76 },
    minimumDistance: 0.5,
    sections: [{ name: "everyone", count: COUNT, isLoose: true }],
  });
  for (const [index, [name, time]] of Object.entries(TIMES).entries()) {
    const all = formations[index].flat();
    const places = order.map((agent) => all[agent]);
    show.keyframe({ name, time, hold: 2, isInOrder: true }, { everyone: places });
  }
  return { ...show.toScene([WHEELING, PARTING, PARTING]), groups: groups() };
}

/** Seconds; the points of the star have a long way. */
const TIMES = { Circle: 0, Star: 15, Runner: 27, "Five circles": 39 };
/** Everything turns about its middle: all, the groups, their subgroups. */
const WHEELING = { kind: "transition", method: "polar", alignment: "procrustes", hierarchy: true, avoidance: true };
/** Groups go straight and turn about their own middles on the way. */
const PARTING = { ...WHEELING, nodes: [{ group: [], method: "linear" }] };

/** Five middles about the origin, the first straight up or turned from there by so many degrees. */
function around(radius, turn = 0) {
  return ring(radius, PARTS, 90 + turn);
}

/** Places in parts of equal number about middles: the sum of squared ways from everybody to the middle of the own part is least. */
function divided(places, middles) {
  const taken = match(
    middles.flatMap((middle) => new Array(SIZE).fill(middle)),
    places,
  );
  return middles.map((_, part) => taken.slice(part * SIZE, (part + 1) * SIZE));
}

/** Within its part everybody goes where the sum of squared ways is least; all wheel by so many degrees on the way there. */
function chained(formations) {
  let before = null;
  return formations.map(([wheel, parts]) => {
    before = parts.map((places, part) => (before ? match(turned(before[part], wheel), places) : places));
    return before;
  });
}

/** Circles about one middle, the k-th of 6 k agents: as far from each other as from their neighbors. */
function rings(first, last) {
  return Array.from({ length: last - first + 1 }, (_, index) =>
    ring((first + index) * SPACING, 6 * (first + index), 90 + 7 * index),
  ).flat();
}

function spread(drawing, width) {
  return placesIn(drawing, COUNT, width, 0.8);
}

function groups() {
  return Array.from({ length: PARTS * GROUPS }, (_, group) => {
    const color = COLORS[Math.floor(group / GROUPS)][(group % GROUPS) % 2];
    return {
      name: `Group ${group + 1}`,
      color,
      children: Array.from({ length: SUBGROUPS }, (_, part) => ({
        name: `Group ${group + 1}.${part + 1}`,
        color,
        members: Array.from({ length: MEMBERS }, (_, member) => (group * SUBGROUPS + part) * MEMBERS + member),
      })),
    };
  });
}
