import { Show } from "./show.mjs";

const SECTIONS = [
  { name: "Offense", count: 6, prefix: "O", color: "#c64f36", tieWeight: 3 },
  { name: "Defense", count: 8, prefix: "D", color: "#2d48cc", tieWeight: 3 },
];

/** Offense attacks to the right; the last of the defense is the goalkeeper. */
const OFFENSE = [
  [-12, 1],
  [-4, 13],
  [-3, -12],
  [2, 5],
  [5, -5],
  [13, 1.5],
];
const OFFENSE_RUNS = [
  [-4, 1],
  [6, 15],
  [7, -14],
  [13, 6],
  [18, -4],
  [33, 2],
];
const KEEPER = [49, 0];
const MIDFIELD = [
  [4, 9],
  [6, 0],
  [3, -10],
];
const MIDFIELD_FALLS_BACK = [
  [12, 10],
  [14, 1],
  [11, -9],
];
/** The second from below stands too deep: whoever runs to where he stands is onside. */
const LINE_WITH_A_HOLE = [
  [16, 14],
  [16, 5],
  [27, -3],
  [16, -13],
];
const LINE = [
  [17, 14],
  [17, 5],
  [17, -4],
  [17, -13],
];

/** After figure 10: an offside trap that one defender spoils, and the same attack against a level line. */
export function offsideTrap() {
  const defense = (line, midfield) => [...midfield, ...line, KEEPER];
  const stepUp = (line, by) => line.map(([x, y]) => [x + by, y]);
  const stage = { width: 105, depth: 68, backdrop: "soccer" };
  const inOrder = { hold: 0.5, isInOrder: true };
  return new Show({ title: "Offside trap", stage, minimumDistance: 0.5, sections: SECTIONS })
    .keyframe(
      { name: "Uneven line", time: 0, hold: 0.5 },
      { Offense: OFFENSE, Defense: defense(LINE_WITH_A_HOLE, MIDFIELD) },
    )
    .keyframe(
      { name: "The trap fails", time: 4, ...inOrder },
      {
        Offense: OFFENSE_RUNS,
        Defense: defense([...stepUp(LINE_WITH_A_HOLE, 7).slice(0, 2), [35, -2], [23, -13]], MIDFIELD_FALLS_BACK),
      },
    )
    .keyframe({ name: "Level line", time: 8, ...inOrder }, { Offense: OFFENSE, Defense: defense(LINE, MIDFIELD) })
    .keyframe(
      { name: "The trap holds", time: 12, ...inOrder },
      { Offense: OFFENSE_RUNS, Defense: defense(stepUp(LINE, 9), MIDFIELD_FALLS_BACK) },
    )
    .toScene(["spectral", "auto", "spectral"].map((method) => ({ kind: "transition", method })));
}
