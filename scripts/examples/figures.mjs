import { arc, block, moved, turned } from "./places.mjs";
import { Show } from "./show.mjs";

// Small scenes, one idea each.

export function threeBlocks() {
  const twelve = block(4, 3, 1.5);
  const sections = ["Left", "Middle", "Right"].map((name) => ({ name, count: 12, prefix: name[0], tieWeight: 10 }));
  const triangle = (turn) => ({
    Left: moved(turned(twelve, turn), ...arc(6.6, 210 + turn, 210 + turn, 1)[0]),
    Middle: moved(turned(twelve, turn), ...arc(6.6, 90 + turn, 90 + turn, 1)[0]),
    Right: moved(turned(twelve, turn), ...arc(6.6, 330 + turn, 330 + turn, 1)[0]),
  });
  return new Show({
    title: "Three blocks changing places",
    stage: { width: 30, depth: 22 },
    minimumDistance: 0.7,
    sections,
  })
    .keyframe(
      { name: "In a row", time: 0, hold: 1 },
      { Left: moved(twelve, -9, 0), Middle: twelve, Right: moved(twelve, 9, 0) },
    )
    .keyframe({ name: "Triangle", time: 6, hold: 1, isInOrder: true }, triangle(0))
    .keyframe({ name: "One on", time: 13, hold: 1, isInOrder: true }, triangle(120))
    .keyframe(
      { name: "All changed", time: 19, hold: 1 },
      { Left: moved(twelve, 9, 0), Middle: moved(twelve, -9, 0), Right: twelve },
    )
    .toScene();
}

/** How far the arms of the square swing out into the ring, and on into the diamond; degrees. */
const INTO_RING = 60;
const INTO_DIAMOND = 135;

/** A square in four arms about its middle, and the ring they open to. */
export function gridToRing() {
  // Four by three, above the middle and to its right: four quarter turns tile the square of 7 × 7 but its middle.
  const arm = moved(block(4, 3, 1.6), 2.4, 3.2);
  const arms = ["North", "West", "South", "East"];
  const sections = [
    ...arms.map((name) => ({ name, count: 12, prefix: name[0] })),
    { name: "middle", count: 1, isLoose: true },
  ];
  const formation = (places) => ({
    middle: [[0, 0]],
    ...Object.fromEntries(arms.map((name, index) => [name, turned(places, 90 * index)])),
  });
  return new Show({ title: "Grid to ring", stage: { width: 30, depth: 22 }, minimumDistance: 0.7, sections })
    .keyframe({ name: "Grid", time: 0, hold: 1 }, formation(arm))
    .keyframe(
      { name: "Ring", time: 7, hold: 1, turn: INTO_RING },
      formation(turned(arc(9, 11.25, 93.75, 12), INTO_RING)),
    )
    .keyframe(
      { name: "Diamond", time: 14, hold: 1, turn: INTO_DIAMOND - INTO_RING },
      formation(turned(arm, INTO_DIAMOND)),
    )
    .toScene();
}
