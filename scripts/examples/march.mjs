/** Frames a second of the recording. */
const RATE = 5;

/** Times of its frames: the show from its first second to its last. */
export function marchTimes(scene) {
  const last = scene.keyframes.at(-1);
  const count = Math.floor((last.time + last.hold) * RATE) + 1;
  return Array.from({ length: count }, (_, frame) => frame / RATE);
}

/** A motion as trackers of video write it (the text format of JuPedSim): people sway, and stand somewhere on a field. */
export function marchText({ times, positions }) {
  const rows = times.flatMap((time, frame) =>
    positions[frame].map(([x, y], agent) => {
      const places = [x + 40 + sway(time, agent), y + 25 + sway(time, agent + 0.5)].map((value) => value.toFixed(2));
      return `${agent + 1}\t${frame}\t${places.join("\t")}\t0`;
    }),
  );
  return `# framerate: ${RATE.toFixed(2)} fps\n# id\tframe\tx/m\ty/m\tz/m\n${rows.join("\n")}\n`;
}

/** Some 20 cm this way and that, for everybody at another time. */
function sway(time, agent) {
  return 0.12 * Math.sin(0.9 * time + 2.1 * agent) + 0.08 * Math.sin(2.3 * time + 1.3 * agent);
}
