import type { ExampleCard } from "../../panels/dialogs/services";

/** What bands do on a field. */
export const SHOWS: readonly ExampleCard[] = [
  {
    id: "band",
    title: "Autumn opener",
    description: "A band in six sections, each tied to itself",
    agentCount: 25,
    keyframeCount: 4,
  },
  {
    id: "half-time",
    title: "Half-time",
    description: "A field show: a greeting, a smile, a wink, a star",
    agentCount: 200,
    keyframeCount: 4,
  },
  {
    id: "flower",
    title: "Flower",
    description: "Petals keep their neighbors",
    agentCount: 208,
    keyframeCount: 3,
  },
  {
    id: "star-to-five-rings",
    title: "Star to five rings",
    description: "Five groups wheel out of one disc",
    agentCount: 1260,
    keyframeCount: 3,
  },
  {
    id: "three-blocks",
    title: "Three blocks",
    description: "They change places and stay blocks",
    agentCount: 36,
    keyframeCount: 4,
  },
  {
    id: "grid-to-ring",
    title: "Grid to ring",
    description: "Four arms of a square swing out to a circle",
    agentCount: 49,
    keyframeCount: 3,
  },
];
