import { brushed, crowdShow, spread } from "./crowd.mjs";
import { assigned } from "./engine.mjs";

// What paper D compares, between formations of its smallest crowd.

const COUNT = 110;

const awl = () => spread('<path d="M 50 10 L 82 90 L 18 90 Z"/>', COUNT, 15);
const goose = () => spread(brushed(["M 8 84 L 50 18 L 92 84"], 13), COUNT, 27);
const round = () => spread('<circle cx="50" cy="50" r="32" fill="none" stroke="black" stroke-width="16"/>', COUNT, 22);

/** After figures 10 and 11: the same change, everybody where the sum of one cost after the other is least. */
export function threeCosts() {
  const [start, slots] = [awl(), goose()];
  const ways = [
    ["Least effort", "least-effort"],
    ["Euclidean", "euclidean"],
    ["Manhattan", "manhattan"],
  ];
  const pictures = ways.flatMap(([name, cost], index) => [
    { name: index === 0 ? "Start" : "Start again", places: start, isInOrder: true, way: { method: "linear" } },
    { name, places: assigned(start, slots, cost), isInOrder: true, way: { assignment: { cost } } },
  ]);
  return crowdShow({
    title: "Who goes where, by three costs",
    stage: { width: 44, depth: 32 },
    groupCount: 5,
    groupedBy: 2,
    seconds: 7,
    pictures,
  });
}

/** After figures 13 and 14: one change, to be moved by a crowd and by what others have. */
export function besideOthers() {
  const [start, slots] = [goose(), round()];
  return crowdShow({
    title: "A crowd and what others do",
    stage: { width: 44, depth: 32 },
    groupCount: 5,
    seconds: 8,
    pictures: [
      { name: "Goose", places: start },
      {
        name: "Round",
        places: assigned(start, slots, "least-effort"),
        isInOrder: true,
        way: { assignment: { cost: "least-effort" } },
      },
    ],
  });
}
