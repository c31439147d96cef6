import { along, arc, block, degrees, line, moved, ring, turned } from "./places.mjs";
import { Show } from "./show.mjs";

const SECTIONS = [
  { name: "Piccolos", count: 3, prefix: "P", tieWeight: 4 },
  { name: "Trumpets", count: 5, prefix: "T", tieWeight: 4 },
  { name: "Saxophones", count: 5, prefix: "S", tieWeight: 4 },
  { name: "Trombones", count: 5, prefix: "B", tieWeight: 4 },
  { name: "Drums", count: 4, prefix: "D", tieWeight: 10 },
  { name: "Guard", count: 3, prefix: "G", tieWeight: 4 },
];

/** How far the band turns into the wheel, and on into the pinwheel; degrees. */
const INTO_WHEEL = 120;
const INTO_PINWHEEL = 70;

/** A small band in six sections, turning from one figure to the next: the first thing a newcomer sees. */
export function band() {
  return new Show({
    title: "Autumn opener",
    stage: { width: 30, depth: 20 },
    minimumDistance: 0.7,
    sections: SECTIONS,
  })
    .keyframe({ name: "Opener", time: 0, hold: 1 }, opener())
    .keyframe({ name: "Wheel", time: 7, hold: 1, turn: INTO_WHEEL }, turnedAll(wheel(), INTO_WHEEL))
    .keyframe({ name: "Heart", time: 14, hold: 1, turn: -INTO_WHEEL }, heart())
    .keyframe({ name: "Pinwheel", time: 21, hold: 1, turn: INTO_PINWHEEL }, turnedAll(pinwheel(), INTO_PINWHEEL))
    .toScene();
}

function opener() {
  return {
    Piccolos: line([-11, 2.5], [-11, -2.5], 3),
    Trumpets: moved(arc(6, 165, 75, 5), -3.5, 0),
    Saxophones: line([-5, -5.5], [5, -5.5], 5),
    Trombones: moved(arc(6, 15, 105, 5), 3.5, 0),
    Drums: moved(block(4, 1, 2.2), 0, -1.5),
    Guard: line([11, 2.5], [11, -2.5], 3),
  };
}

function wheel() {
  const flare = [
    [7.6, 1.6],
    [9.3, 0],
    [7.6, -1.6],
  ];
  return {
    Drums: turned(block(2, 2, 2.2), 45),
    Trumpets: arc(5.6, 100, 176, 5),
    Trombones: arc(5.6, 4, 80, 5),
    Saxophones: arc(5.6, 226, 314, 5),
    Piccolos: turned(flare, 180),
    Guard: flare,
  };
}

function heart() {
  const outline = heartOutline(21);
  return {
    Drums: moved(ring(1.7, 4), 0, 0.6),
    Trumpets: outline.slice(0, 5),
    Piccolos: outline.slice(5, 8),
    Saxophones: outline.slice(8, 13),
    Guard: outline.slice(13, 16),
    Trombones: outline.slice(16, 21),
  };
}

function pinwheel() {
  return {
    Drums: block(2, 2, 2),
    Guard: vane(-5, 3),
    Trombones: vane(58, 5),
    Trumpets: vane(122, 5),
    Piccolos: vane(185, 3),
    Saxophones: vane(270, 5),
  };
}

/** A bent spoke from near the middle outward. */
function vane(angle, count) {
  return Array.from({ length: count }, (_, index) => turned([[3.4 + 1.5 * index, 0]], angle + 9 * index)[0]);
}

/** Evenly from left of the notch over the left lobe, around to the right lobe; nobody stands in the notch. */
function heartOutline(count) {
  const [first, last] = [32, 328];
  const curve = Array.from({ length: last - first + 1 }, (_, step) => {
    const angle = degrees(-(first + step));
    const x = 16 * Math.sin(angle) ** 3;
    const y = 13 * Math.cos(angle) - 5 * Math.cos(2 * angle) - 2 * Math.cos(3 * angle) - Math.cos(4 * angle);
    return [x * 0.54, y * 0.52 + 1];
  });
  return along(curve, count);
}

function turnedAll(formation, angle) {
  return Object.fromEntries(Object.entries(formation).map(([section, places]) => [section, turned(places, angle)]));
}
