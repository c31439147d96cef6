// Who belongs together: agents that are near each other in every formation.

/**
 * The agents in `counts[0]` parts of equal number, each in `counts[1]` parts, and so on: nested lists of agents.
 *
 * Parts are cut again and again across the direction in which they spread most, seen in all formations at once.
 *
 * @param {[number, number][][]} formations where everybody stands, by agent, one formation after the other
 */
export function together(formations, agents, [count, ...counts]) {
  if (!count) return agents;
  const places = new Map(agents.map((agent) => [agent, formations.flatMap((formation) => formation[agent])]));
  return parts(places, agents, count).map((part) => together(formations, part, counts));
}

function parts(places, agents, count) {
  if (count === 1) return [agents];
  const first = Math.floor(count / 2);
  const along = spread(agents.map((agent) => places.get(agent)));
  const share = new Map(agents.map((agent) => [agent, dot(places.get(agent), along)]));
  const sorted = [...agents].sort((a, b) => share.get(a) - share.get(b) || a - b);
  const cut = Math.round((agents.length / count) * first);
  return [...parts(places, sorted.slice(0, cut), first), ...parts(places, sorted.slice(cut), count - first)];
}

/** Enough for the cut to stand still; directions that spread alike make equally good cuts. */
const ROUNDS = 60;

/** The direction in which points spread most. */
function spread(points) {
  const size = points[0].length;
  const middle = Array.from(
    { length: size },
    (_, axis) => points.reduce((sum, point) => sum + point[axis], 0) / points.length,
  );
  const centered = points.map((point) => point.map((value, axis) => value - middle[axis]));
  // Nothing that occurs in a formation: a start across its axis would stay there.
  let along = Array.from({ length: size }, (_, axis) => Math.cos(1 + 2.3 * axis));
  for (let round = 0; round < ROUNDS; round += 1) {
    const next = new Array(size).fill(0);
    for (const point of centered) {
      const share = dot(point, along);
      for (let axis = 0; axis < size; axis += 1) next[axis] += share * point[axis];
    }
    const length = Math.hypot(...next) || 1;
    along = next.map((value) => value / length);
  }
  return along;
}

function dot(a, b) {
  return a.reduce((sum, value, axis) => sum + value * b[axis], 0);
}
