import { annulus, arc, degrees, moved, rowsWithin, turned } from "./places.mjs";
import { Show } from "./show.mjs";

const ARMS = ["North", "West", "Southwest", "Southeast", "East"];
const COLORS = ["#2d48cc", "#b98800", "#024b3b", "#c64f36", "#1399e4"];
const FIFTH = degrees(36);
/** How far everybody wheels on the way to the star, and again on the way to the rings; degrees. */
const WHEEL = 72;

/** 1,260 in five groups that leave together. */
export function starToRings() {
  const count = 252;
  const sections = ARMS.map((name, index) => ({ name, count, color: COLORS[index] }));
  const arm = rowsWithin(starHalfWidth, 0.9, STAR.tip - 0.3, count);
  const circle = moved(annulus(3.8, 8.6, 6, count), 0, 18);
  const formation = (places, turn) =>
    Object.fromEntries(ARMS.map((name, index) => [name, turned(places, 72 * index + turn)]));
  const polar = { kind: "transition", method: "polar", alignment: "procrustes" };
  return new Show({ title: "Star to five rings", stage: { width: 90, depth: 64 }, minimumDistance: 0.5, sections })
    .keyframe({ name: "Disc", time: 0, hold: 1 }, formation(discFifth(), -WHEEL))
    .keyframe({ name: "Star", time: 14, hold: 1, turn: WHEEL }, formation(arm, 0))
    .keyframe({ name: "Five rings", time: 28, hold: 1, turn: WHEEL }, formation(circle, WHEEL))
    .toScene([polar, polar]);
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
