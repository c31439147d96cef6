/** Meters of one unit of a preview's numbers. */
const STEP = 0.01;
const UNGROUPED = "#1d2a3a";
/** The page gives them to groups without a color, in this order. */
const GROUP_COLORS = [
  "#c64f36",
  "#2d48cc",
  "#b98800",
  "#024b3b",
  "#e85fa8",
  "#1399e4",
  "#620687",
  "#07875b",
  "#4c5600",
];

/** A large scene shows its motion in fewer samples. */
function sampleCount(scene) {
  return scene.keyframes[0].positions.length > 500 ? 13 : 25;
}

/** Times of a transition's preview, evenly from its departure to its arrival. */
export function sampleTimes(scene, segment) {
  const [from, to] = [scene.keyframes[segment], scene.keyframes[segment + 1]];
  const start = from.time + (from.hold ?? 0);
  const count = sampleCount(scene);
  return Array.from({ length: count }, (_, index) => start + ((to.time - start) * index) / (count - 1));
}

/** What the gallery draws: colors in runs, and x, y of every agent, sample by sample, as 16-bit numbers in base 64. */
export function previewOf(scene, { times, positions }) {
  const agentCount = positions[0].length;
  // Across and away, or across and up: what is shown in space is seen from the front.
  const seen = positions.map((places) => places.map(([x, y, height]) => [x, height ?? y]));
  const numbers = Int16Array.from(seen.flat(2), (value) => Math.round(value / STEP));
  return {
    agentCount,
    sampleCount: times.length,
    duration: times[times.length - 1] - times[0],
    step: STEP,
    colors: runs(colorsOf(scene, agentCount)),
    xy: Buffer.from(numbers.buffer).toString("base64"),
  };
}

function colorsOf(scene, agentCount) {
  const colors = new Array(agentCount).fill(UNGROUPED);
  const color = (groups, inherited) => {
    for (const [index, group] of groups.entries()) {
      const own = group.color ?? inherited ?? GROUP_COLORS[index % GROUP_COLORS.length];
      for (const agent of group.members ?? []) colors[agent] = own;
      color(group.children ?? [], own);
    }
  };
  color(scene.groups ?? []);
  for (const [index, agent] of (scene.agents ?? []).entries()) if (agent.color) colors[index] = agent.color;
  return colors;
}

function runs(colors) {
  const found = [];
  for (const color of colors) {
    const last = found.at(-1);
    if (last?.[0] === color) last[1] += 1;
    else found.push([color, 1]);
  }
  return found;
}
