import { match } from "./matching.mjs";
import { degrees, star } from "./places.mjs";
import { Show } from "./show.mjs";
import { circles, fill, runner } from "./silhouettes.mjs";

/** Groups of subgroups of agents: 1,260 in all. */
const [GROUPS, SUBGROUPS, MEMBERS] = [35, 6, 6];
const COLORS = ["#c64f36", "#2d48cc", "#b98800", "#024b3b", "#e85fa8", "#1399e4", "#620687"];
const COUNT = GROUPS * SUBGROUPS * MEMBERS;

/** After figure 11: a circle, a star, somebody who runs, five circles; in three levels of groups. */
export function thousand() {
  const fifths = Array.from({ length: 5 }, (_, index) => [
    19 * Math.cos(degrees(90 + 72 * index)),
    19 * Math.sin(degrees(90 + 72 * index)),
  ]);
  const pictures = [
    ["Circle", circles([[0, 0]], 22)],
    ["Star", [star(5, 31, 13)]],
    ["Runner", runner()],
    ["Five circles", circles(fifths, 9)],
  ];
  let before = null;
  const show = new Show({
    title: "Twelve hundred and sixty",
    stage: { width: 90, depth: 64 },
    minimumDistance: 0.4,
    sections: [{ name: "everyone", count: COUNT, isLoose: true }],
  });
  for (const [index, [name, outlines]] of pictures.entries()) {
    const tree = inOrderOf(before, divided(fill(outlines, COUNT)));
    before = tree;
    show.keyframe({ name, time: 11 * index, hold: 2, isInOrder: true }, { everyone: tree.flat(2) });
  }
  const way = { kind: "transition", method: "polar", alignment: "procrustes", hierarchy: true };
  return { ...show.toScene([way, way, way]), groups: groups() };
}

/** Places in 35 parts of 6 parts of 6, each part together. */
function divided(places) {
  return parts(places, GROUPS).map((group) => parts(group, SUBGROUPS));
}

/** Cut again and again across the longer side, so that parts are equal in number and compact. */
function parts(places, count) {
  if (count === 1) return [places];
  const [dx, dy] = [0, 1].map((axis) => {
    const values = places.map((place) => place[axis]);
    return Math.max(...values) - Math.min(...values);
  });
  const axis = dx >= dy ? 0 : 1;
  const sorted = [...places].sort((a, b) => a[axis] - b[axis] || a[1 - axis] - b[1 - axis]);
  const first = Math.floor(count / 2);
  const cut = (places.length / count) * first;
  return [...parts(sorted.slice(0, cut), first), ...parts(sorted.slice(cut), count - first)];
}

/** The tree of places with its parts, and the places in them, in the order of those they are nearest to before. */
function inOrderOf(before, tree) {
  if (!before) return tree;
  return reordered(before, tree).map((group, index) =>
    reordered(before[index], group).map((members, part) => match(before[index][part], members)),
  );
}

/** Parts in the order that matches their middles with least squares. */
function reordered(before, now) {
  const middles = now.map((part) => middleOf(part));
  const taken = match(
    before.map((part) => middleOf(part)),
    middles,
  );
  return taken.map((middle) => now[middles.indexOf(middle)]);
}

function middleOf(part) {
  const places = part.flat(Infinity);
  let [x, y] = [0, 0];
  for (let k = 0; k < places.length; k += 2) {
    x += places[k];
    y += places[k + 1];
  }
  return [(2 * x) / places.length, (2 * y) / places.length];
}

function groups() {
  return Array.from({ length: GROUPS }, (_, group) => ({
    name: `Group ${group + 1}`,
    color: COLORS[group % COLORS.length],
    children: Array.from({ length: SUBGROUPS }, (_, part) => ({
      name: `Group ${group + 1}.${part + 1}`,
      color: COLORS[group % COLORS.length],
      members: Array.from({ length: MEMBERS }, (_, member) => (group * SUBGROUPS + part) * MEMBERS + member),
    })),
  }));
}
