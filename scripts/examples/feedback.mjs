import { brushed, crowdShow, spread } from "./crowd.mjs";

/** After figure 12: the same change without feedback and with it. */
export function feedback() {
  const awl = spread('<path d="M 50 10 L 82 90 L 18 90 Z"/>', 300, 24);
  const goose = spread(brushed(["M 8 84 L 50 18 L 92 84"], 13), 300, 44);
  const back = { method: "linear" };
  return crowdShow({
    title: "Feedback, off and on",
    stage: { width: 70, depth: 50 },
    groupCount: 6,
    seconds: 7,
    pictures: [
      { name: "Start", places: awl },
      { name: "Without", places: goose, way: { crowd: { directionFeedback: false, speedFeedback: false } } },
      { name: "Start again", places: awl, way: back },
      { name: "With", places: goose },
    ],
  });
}
