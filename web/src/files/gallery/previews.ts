import type { Preview } from "../../panels/dialogs/services";

/** A preview as it is stored: colors in runs, places as 16-bit multiples of `step` meters in base 64. */
export interface StoredPreview {
  readonly agentCount: number;
  readonly sampleCount: number;
  readonly duration: number;
  readonly step: number;
  readonly colors: readonly (readonly [color: string, count: number])[];
  readonly xy: string;
  readonly leastDistances: readonly number[];
  readonly distortions: readonly number[];
}

/** The preview of an example, beside the page. */
export async function loadPreview(id: string): Promise<Preview> {
  const response = await fetch(`./examples/previews/${id}.json`);
  if (!response.ok) throw new Error(`The preview could not be fetched (${response.status}).`);
  return unpack((await response.json()) as StoredPreview);
}

export function unpack({ step, colors, xy, ...preview }: StoredPreview): Preview {
  const bytes = Uint8Array.from(atob(xy), (letter) => letter.charCodeAt(0));
  const numbers = new DataView(bytes.buffer);
  return {
    ...preview,
    xy: Float32Array.from({ length: bytes.length / 2 }, (_, index) => numbers.getInt16(2 * index, true) * step),
    colors: colors.flatMap(([color, count]) => new Array<string>(count).fill(color)),
  };
}
