import type { ExampleCard } from "../../panels/dialogs/services";

/** After the figures of "Collective Crowd Formation Transform" (2016), in their order. */
export const CROWDS: readonly ExampleCard[] = [
  {
    id: "bird",
    title: "Bird in four hands",
    description: "The character for bird: scratched into bone, cast, brushed, and as it is written today",
    agentCount: 400,
    keyframeCount: 4,
  },
  {
    id: "running-man",
    title: "Running man",
    description: "A round crowd becomes somebody who runs there and back",
    agentCount: 600,
    keyframeCount: 3,
  },
  {
    id: "fighters",
    title: "Awl, goose, hook and round",
    description: "Four formations of fighters before a city gate",
    agentCount: 300,
    keyframeCount: 4,
  },
];
