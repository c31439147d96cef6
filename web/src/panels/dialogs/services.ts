import type { Scene } from "../../document/scene";

/** An example as the gallery lists it; `id` names its file. */
export interface ExampleCard {
  readonly id: string;
  readonly title: string;
  readonly description: string;
  readonly agentCount: number;
  readonly keyframeCount: number;
}

/** One transition of an example, small enough to load with the gallery. */
export interface Preview {
  readonly agentCount: number;
  readonly sampleCount: number;
  /** Seconds from the first sample to the last. */
  readonly duration: number;
  /** Meters; x, y of every agent, sample by sample. */
  readonly xy: Float32Array;
  /** Stored colors by agent. */
  readonly colors: readonly string[];
}

/** What the dialogs do beyond the studio: files, addresses, examples. Wired in main.ts. */
export interface DialogServices {
  /** The page's address, without a fragment. */
  readonly address: string;
  /** The scene with what auto chose written down, as it is shared. */
  sceneToShare(): Scene;
  loadExamples(): Promise<readonly ExampleCard[]>;
  /** By example id. */
  loadPreviews(): Promise<ReadonlyMap<string, Preview>>;
  openExample(example: ExampleCard): Promise<void>;
  /** Hands the person a file named after the scene. */
  saveFile(ending: string, text: string, type: string): void;
}
