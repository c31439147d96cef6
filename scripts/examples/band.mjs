import { along, arc, block, degrees, line, moved, ring, turned } from "./places.mjs";
import { Show } from "./show.mjs";

const SECTIONS = [
  { name: "Piccolos", count: 3, prefix: "P" },
  { name: "Trumpets", count: 5, prefix: "T" },
  { name: "Saxophones", count: 5, prefix: "S" },
  { name: "Trombones", count: 5, prefix: "B" },
  { name: "Drums", count: 4, prefix: "D", tieWeight: 10 },
  { name: "Guard", count: 3, prefix: "G" },
].map((section) => ({ tieWeight: 4, ...section }));

/** A small band in six sections: the first thing a newcomer sees. */
export function band() {
  const heart = heartOutline(21);
  return new Show({
    title: "Autumn opener",
    stage: { width: 30, depth: 20 },
    minimumDistance: 0.7,
    sections: SECTIONS,
  })
    .keyframe(
      { name: "Opener", time: 0, hold: 1 },
      {
        Piccolos: line([-11, 2.5], [-11, -2.5], 3),
        Trumpets: moved(arc(6, 165, 75, 5), -3.5, 0),
        Saxophones: line([-5, -5.5], [5, -5.5], 5),
        Trombones: moved(arc(6, 15, 105, 5), 3.5, 0),
        Drums: moved(block(4, 1, 2.2), 0, -1.5),
        Guard: line([11, 2.5], [11, -2.5], 3),
      },
    )
    .keyframe(
      { name: "Sun", time: 7, hold: 1 },
      {
        Drums: turned(block(2, 2, 2.2), 45),
        Trumpets: arc(6.2, 196, 104, 5),
        Trombones: arc(6.2, 76, -16, 5),
        Saxophones: arc(6.2, 224, 316, 5),
        Piccolos: [
          [-10, 1.8],
          [-12, 0],
          [-10, -1.8],
        ],
        Guard: [
          [10, 1.8],
          [12, 0],
          [10, -1.8],
        ],
      },
    )
    .keyframe(
      { name: "Heart", time: 14, hold: 1 },
      {
        Drums: moved(ring(1.7, 4, 90), 0, 0.6),
        Trumpets: heart.slice(0, 5),
        Piccolos: heart.slice(5, 8),
        Saxophones: heart.slice(8, 13),
        Guard: heart.slice(13, 16),
        Trombones: heart.slice(16, 21),
      },
    )
    .keyframe(
      { name: "Company front", time: 21, hold: 1 },
      {
        Trumpets: line([-12, 4], [-2.4, 4], 5),
        Trombones: line([2.4, 4], [12, 4], 5),
        Piccolos: line([-9.6, 0], [-4.8, 0], 3),
        Drums: block(4, 1, 2.2),
        Guard: line([4.8, 0], [9.6, 0], 3),
        Saxophones: line([-6, -4.5], [6, -4.5], 5),
      },
    )
    .toScene();
}

/** Evenly from left of the notch over the left lobe, around to the right lobe; nobody stands in the notch. */
function heartOutline(count) {
  const [first, last] = [32, 328];
  const curve = Array.from({ length: last - first + 1 }, (_, step) => {
    const angle = degrees(-(first + step));
    const x = 16 * Math.sin(angle) ** 3;
    const y = 13 * Math.cos(angle) - 5 * Math.cos(2 * angle) - 2 * Math.cos(3 * angle) - Math.cos(4 * angle);
    return [x * 0.52, y * 0.5 + 1];
  });
  return along(curve, count);
}
