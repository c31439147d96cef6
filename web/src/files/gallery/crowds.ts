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
  {
    id: "along-a-curve",
    title: "Along a curve",
    description: "Figure 6: a block travels along a path, an arrow on its crest and a ring at its end",
    agentCount: 180,
    keyframeCount: 3,
  },
  {
    id: "ape-to-human",
    title: "From ape to human",
    description: "Figure 7: an ape rises on its way up a hill, and walks on as a human",
    agentCount: 400,
    keyframeCount: 3,
  },
  {
    id: "round-an-obstacle",
    title: "Round an obstacle",
    description:
      "Figure 8: a block opens about a fountain and closes, rings a stage, and walks back past both as a crowd",
    agentCount: 36,
    keyframeCount: 4,
  },
  {
    id: "two-groups-crossing",
    title: "Two groups crossing",
    description: "Figure 9: two blocks go through each other at right angles, then end-on, and are whole again",
    agentCount: 128,
    keyframeCount: 4,
  },
  {
    id: "three-costs",
    title: "Who goes where, by three costs",
    description: "Figures 10 and 11, table 2: least effort keeps neighbors together, plain distances mix them",
    agentCount: 110,
    keyframeCount: 6,
    view: { kind: "compare", segments: [0, 2, 4], table: "costs" },
  },
  {
    id: "feedback",
    title: "Feedback, off and on",
    description: "Figure 12: sharing direction and speed with who is near, places tell less of directions",
    agentCount: 300,
    keyframeCount: 4,
    view: { kind: "compare", segments: [0, 2], table: "feedback" },
  },
  {
    id: "beside-others",
    title: "A crowd and what others do",
    description: "Figures 13 and 14, table 3: ours beside social forces alone and ORCA, between the same formations",
    agentCount: 110,
    keyframeCount: 2,
    view: { kind: "compare", segments: [0, 0], preset: "others", table: "others" },
  },
];
