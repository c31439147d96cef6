import { along, block, line, moved, ring, turned } from "./places.mjs";
import { Show } from "./show.mjs";

const PETALS = ["Petal 1", "Petal 2", "Petal 3", "Petal 4", "Petal 5", "Petal 6"];
/** The middle of the flower above the middle of the stage, meters. */
const UP = 5.5;
/** Squads turn about the middle of all, and each about its own. */
const WHEELING = { kind: "transition", method: "polar", alignment: "procrustes", hierarchy: true, avoidance: true };
/** How far the squads wheel into the bud, and the bud into the flower; degrees. */
const INTO_BUD = 75;
const INTO_FLOWER = 30;

const SECTIONS = [
  ...PETALS.map((name, index) => ({ name, count: 24, color: index % 2 === 0 ? "#e85fa8" : "#c64f36", tieWeight: 4 })),
  { name: "Heart", count: 24, color: "#b98800", tieWeight: 4 },
  { name: "Stem", count: 26, color: "#07875b", tieWeight: 4 },
  { name: "Leaf", count: 14, color: "#024b3b", tieWeight: 4 },
];

/** Squads close to a bud, and the bud opens: petals keep their neighbors. */
export function flower() {
  const squad = moved(block(4, 6, 1.2), 0, 8.4);
  const bud = [...petalEdge(8.8, 1.8, 18), ...line([0, 4.7], [0, 7.7], 6)];
  const petal = [...petalEdge(11.4, 2.9, 18), ...line([0, 5.4], [0, 9.4], 6)];
  const heart = [...ring(1.2, 6), ...ring(2.5, 18)];
  const stem = moved(block(2, 13, 0.9, 1.05), 0, -12.2);
  return new Show({ title: "Flower", stage: { width: 60, depth: 44 }, minimumDistance: 0.5, sections: SECTIONS })
    .keyframe(
      { name: "Squads", time: 0, hold: 1 },
      {
        ...around(squad, -INTO_BUD),
        Heart: turnedAbout(block(6, 4, 1.1), -INTO_BUD),
        Stem: moved(block(13, 2, 1.2), -8.4, -12.2),
        Leaf: moved(block(7, 2, 1.2), 8.4, -12.2),
      },
    )
    .keyframe(
      { name: "Bud", time: 9, hold: 1, turn: INTO_BUD },
      { ...around(bud, 0), Heart: turnedAbout(heart, 0), Stem: stem, Leaf: leafAt(-22, 9) },
    )
    .keyframe(
      { name: "Flower", time: 16, hold: 1, turn: INTO_FLOWER },
      { ...around(petal, INTO_FLOWER), Heart: turnedAbout(heart, INTO_FLOWER), Stem: stem, Leaf: leafAt(-50, 10.2) },
    )
    .toScene([WHEELING, WHEELING]);
}

function around(places, start) {
  return Object.fromEntries(PETALS.map((name, index) => [name, turnedAbout(places, start + 60 * index)]));
}

function turnedAbout(places, angle) {
  return moved(turned(places, angle), 0, UP);
}

/** From the stem at its lower right, leaning away by an angle. */
function leafAt(angle, length) {
  return moved(turned(petalEdge(length, 2, 14, 1.4), angle), 1.1, -17.2);
}

/** A petal's edge, evenly from its foot outward and back. */
function petalEdge(length, width, count, foot = 3.6) {
  const curve = Array.from({ length: 240 }, (_, step) => {
    const angle = (2 * Math.PI * step) / 240;
    return [Math.sin(angle) * width, foot + (length - foot) * Math.sin(angle / 2) ** 1.2];
  });
  return along(curve, count, true);
}
