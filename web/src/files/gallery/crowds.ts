import type { ExampleCard } from "../../panels/dialogs/services";

/** After the figures of "Collective Crowd Formation Transform" (2015), in their order. */
export const CROWDS: readonly ExampleCard[] = [
  {
    id: "bird",
    title: "Bird in four hands",
    description: "Figure 2: the character for bird, scratched into bone, cast, brushed, and as it is written today",
    agentCount: 400,
    keyframeCount: 4,
  },
  {
    id: "running-man",
    title: "Running man",
    description: "Figure 3: a round crowd becomes somebody who runs there and back",
    agentCount: 600,
    keyframeCount: 3,
  },
  {
    id: "martial-arts",
    title: "Martial arts",
    description: "Figure 4: monks line up, and all together are one who fights",
    agentCount: 400,
    keyframeCount: 5,
  },
  {
    id: "fighters",
    title: "Awl, goose, hook and round",
    description: "Figure 5: four formations of fighters before a city gate",
    agentCount: 300,
    keyframeCount: 4,
  },
];
