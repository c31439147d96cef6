import { brushed, crowdShow, spread } from "./crowd.mjs";

/** After figure 5: fighters before a city gate, in the formations called awl, goose, hook and round. */
export function fighters() {
  const goose = brushed(["M 8 84 L 50 18 L 92 84"], 13);
  const hook = brushed(["M 14 20 L 14 62 C 14 84 36 84 36 64 M 14 30 L 86 30 M 86 20 L 86 62 C 86 84 64 84 64 64"], 10);
  const round = '<circle cx="50" cy="50" r="32" fill="none" stroke="black" stroke-width="16"/>';
  return crowdShow({
    title: "Awl, goose, hook and round",
    stage: { width: 70, depth: 60 },
    groupCount: 6,
    seconds: 7,
    pictures: [
      { name: "Awl", places: spread('<path d="M 50 10 L 82 90 L 18 90 Z"/>', 300, 24) },
      { name: "Goose", places: spread(goose, 300, 44) },
      { name: "Hook", places: spread(hook, 300, 44) },
      { name: "Round", places: spread(round, 300, 36) },
    ],
  });
}
