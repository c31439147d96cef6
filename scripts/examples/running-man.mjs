import { crowdShow, spread } from "./crowd.mjs";
import { drawn, runner } from "./silhouettes.mjs";

/** After figure 3: somebody runs across the field and back. */
export function runningMan() {
  const figure = spread(drawn(runner()), 600, 42);
  return crowdShow({
    title: "Running man",
    stage: { width: 70, depth: 60 },
    groupCount: 8,
    seconds: 9,
    pictures: [
      { name: "Round", places: spread('<circle cx="50" cy="50" r="50"/>', 600, 30) },
      { name: "There", places: figure },
      { name: "And back", places: figure.map(([x, y]) => [-x, y]) },
    ],
  });
}
