import type { ExampleCard, Preview } from "../panels/dialogs/services";

/** What the gallery lists, in its order; `id` names the file. */
export const EXAMPLES: readonly ExampleCard[] = [
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
  {
    id: "four-around-one",
    title: "Four around one",
    description: "They come apart, and ties of ten keep them together",
    agentCount: 17,
    keyframeCount: 4,
  },
  {
    id: "rotated-copy",
    title: "Rotated copy",
    description: "Straight ways shrink it, spectral ways turn it",
    agentCount: 9,
    keyframeCount: 3,
  },
  {
    id: "alignment",
    title: "With and without alignment",
    description: "The same two formations, moved twice",
    agentCount: 6,
    keyframeCount: 4,
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
