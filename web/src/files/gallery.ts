import type { ExampleCard, Preview } from "../panels/dialogs/services";

/** What the gallery lists, section by section, in its order; `id` names the file. */
export const EXAMPLES: readonly ExampleCard[] = [
  {
    id: "band",
    section: "Shows",
    title: "Autumn opener",
    description: "A band in six sections, each tied to itself",
    agentCount: 25,
    keyframeCount: 4,
  },
  {
    id: "half-time",
    section: "Shows",
    title: "Half-time",
    description: "A field show: a greeting, a smile, a wink, a star",
    agentCount: 200,
    keyframeCount: 4,
  },
  {
    id: "flower",
    section: "Shows",
    title: "Flower",
    description: "Petals keep their neighbors",
    agentCount: 208,
    keyframeCount: 3,
  },
  {
    id: "star-to-five-rings",
    section: "Shows",
    title: "Star to five rings",
    description: "Five groups wheel out of one disc",
    agentCount: 1260,
    keyframeCount: 3,
  },
  {
    id: "three-blocks",
    section: "Shows",
    title: "Three blocks",
    description: "They change places and stay blocks",
    agentCount: 36,
    keyframeCount: 4,
  },
  {
    id: "grid-to-ring",
    section: "Shows",
    title: "Grid to ring",
    description: "Four arms of a square swing out to a circle",
    agentCount: 49,
    keyframeCount: 3,
  },
  {
    id: "march",
    section: "The paper's figures",
    title: "A march, recorded",
    description: "Figure 1: pick frames of a recording, and have a new motion made of them",
    agentCount: 25,
    keyframeCount: 0,
    view: { kind: "recording" },
  },
  {
    id: "six-modes",
    section: "The paper's figures",
    title: "Six and their modes",
    description: "Figure 2: six agents, nine ties, and what their modes cut",
    agentCount: 6,
    keyframeCount: 2,
    view: { kind: "modes", segment: 0 },
  },
  {
    id: "rotated-copy",
    section: "The paper's figures",
    title: "Rotated copy",
    description: "Figure 3: straight ways shrink it, polar ways turn it",
    agentCount: 9,
    keyframeCount: 4,
    view: { kind: "compare", segments: [0, 2] },
  },
  {
    id: "alignment",
    section: "The paper's figures",
    title: "With and without alignment",
    description: "Figure 4: not aligned, some go the other way around",
    agentCount: 6,
    keyframeCount: 4,
    view: { kind: "compare", segments: [0, 2] },
  },
  {
    id: "polar-or-spectral",
    section: "The paper's figures",
    title: "Polar or spectral",
    description: "Figure 5: who passes the middle winds, or keeps with the others",
    agentCount: 8,
    keyframeCount: 4,
    view: { kind: "compare", segments: [0, 2] },
  },
  {
    id: "four-around-one",
    section: "The paper's figures",
    title: "Four around one",
    description: "Figure 6: they come apart, and ties of ten keep them together",
    agentCount: 17,
    keyframeCount: 4,
    view: { kind: "compare", segments: [0, 2] },
  },
  {
    id: "small-and-large",
    section: "The paper's figures",
    title: "A small and a large change",
    description: "Figure 7: modes find themselves again, or change places",
    agentCount: 9,
    keyframeCount: 3,
    view: { kind: "modes", segment: 1 },
  },
  {
    id: "winding",
    section: "The paper's figures",
    title: "Winding and smooth",
    description: "Figure 8: modes paired by eigenvalue, and by likeness",
    agentCount: 9,
    keyframeCount: 4,
    view: { kind: "compare", segments: [0, 2] },
  },
  {
    id: "clusters",
    section: "The paper's figures",
    title: "Clusters passing",
    description: "Figure 9: straight through one another, or around as wholes",
    agentCount: 24,
    keyframeCount: 4,
    view: { kind: "compare", segments: [0, 2] },
  },
  {
    id: "clusters-apart",
    section: "The paper's figures",
    title: "Clusters kept apart",
    description: "Figure 9, below: straight ways bend to keep the distance, spectral ones need not",
    agentCount: 24,
    keyframeCount: 4,
    view: { kind: "compare", segments: [0, 2] },
  },
  {
    id: "offside-trap",
    section: "The paper's figures",
    title: "Offside trap",
    description: "Figure 10: one defender spoils it, a level line mends it",
    agentCount: 14,
    keyframeCount: 4,
    view: { kind: "compare", segments: [0, 2] },
  },
  {
    id: "thousand",
    section: "The paper's figures",
    title: "Twelve hundred and sixty",
    description: "Figure 11: a circle, a star, a runner, five circles, in three levels of groups",
    agentCount: 1260,
    keyframeCount: 4,
  },
  {
    id: "bird",
    section: "Shapes of a crowd",
    title: "Bird in four hands",
    description: "The character for bird: scratched into bone, cast, brushed, and as it is written today",
    agentCount: 400,
    keyframeCount: 4,
  },
  {
    id: "running-man",
    section: "Shapes of a crowd",
    title: "Running man",
    description: "A round crowd becomes somebody who runs there and back",
    agentCount: 600,
    keyframeCount: 3,
  },
  {
    id: "fighters",
    section: "Shapes of a crowd",
    title: "Awl, goose, hook and round",
    description: "Four formations of fighters before a city gate",
    agentCount: 300,
    keyframeCount: 4,
  },
  {
    id: "airshow",
    section: "Three dimensions",
    title: "The end",
    description: "Figure 12: ten planes write it in the sky; press P to fly around them",
    agentCount: 10,
    keyframeCount: 6,
  },
];

/** A preview as it is stored: colors in runs, places as 16-bit multiples of `step` meters in base 64. */
interface StoredPreview {
  readonly agentCount: number;
  readonly sampleCount: number;
  readonly duration: number;
  readonly step: number;
  readonly colors: readonly (readonly [color: string, count: number])[];
  readonly xy: string;
}

/** Every example's preview, by id. */
export async function loadPreviews(): Promise<ReadonlyMap<string, Preview>> {
  const response = await fetch("./examples/previews.json");
  if (!response.ok) throw new Error(`The previews could not be fetched (${response.status}).`);
  const stored = (await response.json()) as Record<string, StoredPreview>;
  return new Map(Object.entries(stored).map(([id, preview]) => [id, unpack(preview)]));
}

export function unpack({ agentCount, sampleCount, duration, step, colors, xy }: StoredPreview): Preview {
  const bytes = Uint8Array.from(atob(xy), (letter) => letter.charCodeAt(0));
  const numbers = new DataView(bytes.buffer);
  return {
    agentCount,
    sampleCount,
    duration,
    xy: Float32Array.from({ length: bytes.length / 2 }, (_, index) => numbers.getInt16(2 * index, true) * step),
    colors: colors.flatMap(([color, count]) => new Array<string>(count).fill(color)),
  };
}
