import { block, moved, ring } from "./places.mjs";
import { Show } from "./show.mjs";

// After what "Collective Crowd Formation Transform" (2015) has in figure 9, and what it wishes for at its end.

const KEPT_APART = { kind: "transition", method: "linear", avoidance: true };

/** A block opens about a fountain and closes again, becomes a ring about a stage, and walks back past both as a crowd. */
export function roundAnObstacle() {
  const sections = [
    { name: "Brass", count: 18, prefix: "B", color: "#c64f36" },
    { name: "Reeds", count: 18, prefix: "R", color: "#2d48cc" },
  ];
  const blockAt = (x) => {
    const places = moved(block(6, 6, 1.5), x, 0);
    return { Brass: places.slice(0, 18), Reeds: places.slice(18) };
  };
  const circle = moved(ring(6, 36), 22, 0);
  const ringed = {
    Brass: circle.filter(([, y]) => y > 0),
    Reeds: circle.filter(([, y]) => y <= 0),
  };
  const obstacles = [
    { name: "Fountain", kind: "circle", center: [-11, 0], radius: 2 },
    {
      name: "Stage",
      kind: "polygon",
      points: [
        [8, -3],
        [13, -3],
        [13, -0.5],
        [10.5, -0.5],
        [10.5, 2.5],
        [8, 2.5],
      ],
    },
  ];
  const inOrder = { isInOrder: true };
  return new Show({
    title: "Round an obstacle",
    stage: { width: 64, depth: 30 },
    minimumDistance: 0.5,
    obstacles,
    sections,
  })
    .keyframe({ name: "Block", time: 0, hold: 1 }, blockAt(-24))
    .keyframe({ name: "Past the fountain", time: 10, hold: 1, ...inOrder }, blockAt(-1))
    .keyframe({ name: "Ring", time: 20, hold: 1 }, ringed)
    .keyframe({ name: "Back", time: 34, hold: 1, ...inOrder }, blockAt(-24))
    .toScene([KEPT_APART, KEPT_APART, { ...KEPT_APART, method: "crowd", crowd: { guide: "linear" } }]);
}

/** Two blocks go through each other, at right angles and end-on: each opens while it does, and is whole again. */
export function twoGroupsCrossing() {
  const sections = [
    { name: "First", count: 64, prefix: "F", color: "#c64f36" },
    { name: "Second", count: 64, prefix: "S", color: "#2d48cc" },
  ];
  const eight = block(8, 8, 2);
  const at = ([first, second]) => ({ First: moved(eight, ...first), Second: moved(eight, ...second) });
  const inOrder = { hold: 1, isInOrder: true };
  const [west, east, south, north] = [
    [-22, 0],
    [22, 0],
    [0, -22],
    [0, 22],
  ];
  return new Show({
    title: "Two groups crossing",
    stage: { width: 66, depth: 62 },
    minimumDistance: 1,
    sections,
  })
    .keyframe({ name: "West and south", time: 0, hold: 1 }, at([west, south]))
    .keyframe({ name: "East and north", time: 14, ...inOrder }, at([east, north]))
    .keyframe({ name: "Face to face", time: 22, ...inOrder }, at([east, west]))
    .keyframe({ name: "Changed", time: 35, ...inOrder }, at([west, east]))
    .toScene([KEPT_APART, KEPT_APART, { ...KEPT_APART, hierarchy: true }]);
}
