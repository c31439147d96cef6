import type { Scene } from "../../document/scene";

/** What an example is best looked at with, beside being played. */
export type ExampleView =
  /** Transitions of it that do the same in several ways, or one twice for a known comparison; and what a table tells of them. */
  | {
      readonly kind: "compare";
      readonly segments: readonly number[];
      readonly preset?: string;
      readonly table?: string;
    }
  /** The modes at both ends of one of its transitions. */
  | { readonly kind: "modes"; readonly segment: number }
  /** It is no scene yet but a recording to make one from. */
  | { readonly kind: "recording" };

/** Examples that belong together, under one heading. */
export interface ExampleSection {
  readonly title: string;
  /** The paper whose figures they are. */
  readonly source?: string;
  readonly cards: readonly ExampleCard[];
}

/** An example as the gallery lists it; `id` names its files. */
export interface ExampleCard {
  readonly id: string;
  readonly title: string;
  readonly description: string;
  readonly agentCount: number;
  readonly keyframeCount: number;
  readonly view?: ExampleView;
}

/** One transition of an example, small enough for the gallery to load, and the numbers of all of them. */
export interface Preview {
  readonly agentCount: number;
  readonly sampleCount: number;
  /** Seconds from the first sample to the last. */
  readonly duration: number;
  /** Meters; x, y of every agent, sample by sample. */
  readonly xy: Float32Array;
  /** Stored colors by agent. */
  readonly colors: readonly string[];
  /** Meters, by transition of the whole example; none where there is no motion yet. */
  readonly leastDistances: readonly number[];
  /** Mean over a transition, by transition. */
  readonly distortions: readonly number[];
}

/** What is said of a file or link made while something is shown on trial. */
export const NOT_ACCEPTED = "It leaves out what is shown on trial until you accept it.";

/** What the dialogs do beyond the studio: files, addresses, examples. Wired in main.ts. */
export interface DialogServices {
  /** The page's address, without a fragment. */
  readonly address: string;
  /** The scene as it is shared: with what auto chose written down, without what nobody accepted. */
  sceneToShare(): Scene;
  /** Whether something is shown that nobody accepted yet. */
  isOnTrial(): boolean;
  loadExamples(): Promise<readonly ExampleSection[]>;
  loadPreview(id: string): Promise<Preview>;
  /** Answers whether it is open; if not, the person has been told why. */
  openExample(example: ExampleCard): Promise<boolean>;
  /** Hands the person a file named after the scene. */
  saveFile(ending: string, text: string, type: string): void;
}
