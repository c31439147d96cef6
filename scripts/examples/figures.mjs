import { arc, block, moved, ring, turned } from "./places.mjs";
import { Show } from "./show.mjs";

// Small scenes, one idea each; three follow figures of "Spectral-Based Group Formation Control" (2008).

const PALETTE = ["#c64f36", "#2d48cc", "#b98800", "#024b3b", "#e85fa8", "#1399e4", "#620687", "#07875b", "#4c5600"];
const STAGE = { width: 30, depth: 20 };

/** After figure 3: the same arrangement, turned. Straight ways shrink it; polar ways turn it as one. */
export function rotatedCopy() {
  const shape = [
    [-7, -0.5],
    [-4.5, 1.5],
    [-2, 3.5],
    [0.5, 1.5],
    [3, 3],
    [6.5, 1],
    [3.5, -1],
    [0.5, -3.5],
    [-3, -2.5],
  ];
  const middle = [0, 1].map((axis) => shape.reduce((sum, place) => sum + place[axis], 0) / shape.length);
  const source = moved(shape, -middle[0], -middle[1]);
  const everyone = { name: "everyone", count: shape.length, colors: PALETTE, isLoose: true };
  return new Show({ title: "Rotated copy", stage: STAGE, minimumDistance: 1, sections: [everyone] })
    .keyframe({ name: "Start", time: 0, hold: 1 }, { everyone: source })
    .keyframe({ name: "Turned", time: 6, hold: 1, isInOrder: true }, { everyone: turned(source, 150) })
    .keyframe({ name: "Start again", time: 12, hold: 1, isInOrder: true }, { everyone: source })
    .toScene([
      { kind: "transition", method: "linear" },
      { kind: "transition", method: "spectral" },
    ]);
}

/** After figure 4: not quite the same arrangement, turned. Without the alignment some go the other way around. */
export function aligned() {
  const source = [
    [-6, 1],
    [-2.5, 3.2],
    [2, 2.4],
    [6, 0.4],
    [2.2, -2.6],
    [-2.8, -2.2],
  ];
  const target = [
    [3.55, -4.35],
    [-1.05, -4.2],
    [-2.35, 0.5],
    [-4.8, 3.95],
    [0.5, 4],
    [3.7, -0.05],
  ];
  const everyone = { name: "everyone", count: 6, colors: PALETTE.slice(0, 6), isLoose: true };
  const spectral = { kind: "transition", method: "spectral", sharing: 0 };
  return new Show({ title: "With and without alignment", stage: STAGE, minimumDistance: 0.5, sections: [everyone] })
    .keyframe({ name: "Start", time: 0, hold: 1 }, { everyone: source })
    .keyframe({ name: "Not aligned", time: 6, hold: 1, isInOrder: true }, { everyone: target })
    .keyframe({ name: "Start again", time: 12, hold: 1, isInOrder: true }, { everyone: source })
    .keyframe({ name: "Aligned", time: 18, hold: 1, isInOrder: true }, { everyone: target })
    .toScene([{ ...spectral, alignment: "none" }, spectral, { ...spectral, alignment: "pca" }]);
}

/** After figure 6: four turn about one among others who stand. First as they happen to stand, then tied by ten. */
export function fourAroundOne() {
  const plus = [[0, 0], ...ring(2.4, 4)];
  const others = ring(8, 12, 105).map(([x, y]) => [x * 1.35, y]);
  const before = { Five: moved(plus, -3, -2), Others: others };
  const after = { Five: moved(turned(plus, 135), 3, 2), Others: others };
  const sections = [
    { name: "Five", count: 5, prefix: "F" },
    { name: "Others", count: 12, prefix: "O", isLoose: true },
  ];
  const ties = [1, 2, 3, 4].map((agent) => [0, agent, 10]);
  const loose = {};
  return new Show({ title: "Four around one", stage: STAGE, minimumDistance: 0.5, adjacency: { ties }, sections })
    .keyframe({ name: "Loose", time: 0, hold: 1, adjacency: loose }, before)
    .keyframe({ name: "Came apart", time: 7, hold: 1, adjacency: loose, isInOrder: true }, after)
    .keyframe({ name: "Tied", time: 14, hold: 1, isInOrder: true }, before)
    .keyframe({ name: "Kept together", time: 21, hold: 1, isInOrder: true }, after)
    .toScene(["spectral", "auto", "spectral"].map((method) => ({ kind: "transition", method })));
}

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
