import { along, annulus, arc, block, degrees, line, moved, ring, rowsWithin, turned } from "./places.mjs";
import { Show } from "./show.mjs";

const ARMS = ["North", "West", "Southwest", "Southeast", "East"];
const COLORS = ["#2d48cc", "#b98800", "#024b3b", "#c64f36", "#1399e4"];
const FIFTH = degrees(36);

/** 1,260 in five groups that leave together. */
export function starToRings() {
  const count = 252;
  const sections = ARMS.map((name, index) => ({ name, count, color: COLORS[index] }));
  const arm = rowsWithin(starHalfWidth, 0.9, STAR.tip - 0.3, count);
  const circle = moved(annulus(3.8, 8.6, 6, count), 0, 18);
  const formation = (places) => Object.fromEntries(ARMS.map((name, index) => [name, turned(places, 72 * index)]));
  const spectral = { kind: "transition", method: "spectral" };
  return new Show({
    title: "Star to five rings",
    stage: { width: 90, depth: 64 },
    minimumDistance: 0.5,
    sections,
  })
    .keyframe({ name: "Disc", time: 0, hold: 1 }, formation(discFifth()))
    .keyframe({ name: "Star", time: 8, hold: 1 }, formation(arm))
    .keyframe({ name: "Five rings", time: 20, hold: 1 }, formation(circle))
    .toScene([spectral, spectral]);
}

/** A fifth of a disc of circles: the k-th of 5 k agents, from the second to the 22nd, which makes 1,260 in all. */
function discFifth() {
  const places = [];
  for (let circle = 2; circle <= 22; circle += 1) {
    const gap = 72 / circle;
    places.push(...arc(circle * 0.95, 54 + gap / 2, 126 - gap / 2, circle));
  }
  return places;
}

const STAR = { tip: 31, inner: 12.5 };

/** Half the width of a star's upper fifth; half a spacing from its neighbors, so that two fifths keep their distance. */
function starHalfWidth(y, spacing) {
  const [cornerX, cornerY] = [STAR.inner * Math.sin(FIFTH), STAR.inner * Math.cos(FIFTH)];
  const besideNeighbor = y * Math.tan(FIFTH) - spacing / 2 / Math.cos(FIFTH);
  const underSide = (cornerX * (STAR.tip - y)) / (STAR.tip - cornerY);
  return Math.min(besideNeighbor, underSide);
}

const PETALS = ["Petal 1", "Petal 2", "Petal 3", "Petal 4", "Petal 5", "Petal 6"];

/** A seed opens: petals, a heart, a stem with a leaf. */
export function flower() {
  const sections = [
    ...PETALS.map((name, index) => ({ name, count: 24, color: index % 2 === 0 ? "#e85fa8" : "#c64f36", tieWeight: 4 })),
    { name: "Heart", count: 24, color: "#b98800", tieWeight: 4 },
    { name: "Stem", count: 26, color: "#07875b", tieWeight: 4 },
    { name: "Leaf", count: 14, color: "#024b3b", tieWeight: 4 },
  ];
  const heart = [...ring(1.2, 6), ...ring(2.5, 18)];
  const petal = [...petalEdge(11.4, 2.9, 18), ...line([0, 5.4], [0, 9.4], 6)];
  const bud = [...petalEdge(8.6, 1.75, 18), ...line([0, 4.7], [0, 7.6], 6)];
  const up = 5;
  const open = (places, start) =>
    Object.fromEntries(PETALS.map((name, index) => [name, moved(turned(places, start + 60 * index), 0, up)]));
  const stem = moved(block(2, 13, 0.9, 1.05), 0, -11.8);
  const leaf = moved(turned(petalEdge(10.6, 1.9, 14), -52), -1.6, -17);
  const closed = moved(turned(petalEdge(9.2, 1.3, 14), -14), 0.6, -19);
  return new Show({ title: "Flower", stage: { width: 60, depth: 44 }, minimumDistance: 0.5, sections })
    .keyframe({ name: "Seeds", time: 0, hold: 1 }, rows(sections))
    .keyframe(
      { name: "Bud", time: 8, hold: 1 },
      { ...open(bud, 0), Heart: moved(heart, 0, up), Stem: stem, Leaf: closed },
    )
    .keyframe(
      { name: "Flower", time: 15, hold: 1 },
      { ...open(petal, 30), Heart: moved(heart, 0, up), Stem: stem, Leaf: leaf },
    )
    .toScene();
}

/** A petal's edge, evenly from its foot outward and back. */
function petalEdge(length, width, count) {
  const foot = 3.6;
  const curve = Array.from({ length: 240 }, (_, step) => {
    const angle = (2 * Math.PI * step) / 240;
    return [Math.sin(angle) * width, foot + (length - foot) * Math.sin(angle / 2) ** 1.2];
  });
  return along(curve, count, true);
}

function rows(sections) {
  const places = {};
  let column = 0;
  for (const { name, count } of sections) {
    const columns = Math.ceil(count / 8);
    places[name] = block(columns, 8, 1.5, 2)
      .slice(0, count)
      .map(([x, y]) => [x + (column + columns / 2 - 13.5) * 1.5, y]);
    column += columns;
  }
  return places;
}
