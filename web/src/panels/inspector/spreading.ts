import { type ReadonlySignal, signal } from "@preact/signals";
import { spreadOut } from "../../document/commands/spread-out";
import type { Scene } from "../../document/scene";
import type { DocumentStore, Gesture } from "../../document/store";
import type { Salvage } from "../../engine/salvage";

/** A search under way, which can be given up. */
export interface Search {
  readonly found: Promise<Salvage | null>;
  end(): void;
}

export interface SpreadingParts {
  readonly document: Pick<DocumentStore, "scene" | "beginGesture">;
  /** The transition whose agents are stuck. */
  readonly index: number;
  search(scene: Scene, onProgress: (progress: number) => void): Search;
  announce(text: string): void;
  onProblem(error: unknown): void;
}

export type SpreadingState =
  | { readonly kind: "idle" }
  /** 0..1 */
  | { readonly kind: "searching"; readonly progress: number }
  /** Nothing keeps them apart. */
  | { readonly kind: "helpless"; readonly salvage: Salvage | null }
  /** On the stage, in one gesture of the document. */
  | { readonly kind: "shown"; readonly salvage: Salvage };

/** Letting them spread out, on trial: nothing of it stays unless it is accepted. */
export interface Spreading {
  readonly state: ReadonlySignal<SpreadingState>;
  start(): void;
  accept(): void;
  /** Gives up the search or what is shown. */
  discard(): void;
}

const IDLE: SpreadingState = { kind: "idle" };

export function createSpreading({ document, index, search, announce, onProblem }: SpreadingParts): Spreading {
  const state = signal<SpreadingState>(IDLE);
  let underway: Search | null = null;
  let gesture: Gesture | null = null;

  function show(salvage: Salvage): void {
    gesture = document.beginGesture();
    gesture.preview(spreadOut(index, salvage));
    state.value = { kind: "shown", salvage };
    announce("They spread out. Accept or discard it.");
  }

  function end(how: "commit" | "cancel"): void {
    underway?.end();
    underway = null;
    gesture?.[how]();
    gesture = null;
    state.value = IDLE;
  }

  return {
    state,
    start() {
      end("cancel");
      const scene = document.scene.peek();
      const mine = search(scene, (progress) => {
        if (underway === mine) state.value = { kind: "searching", progress };
      });
      underway = mine;
      state.value = { kind: "searching", progress: 0 };
      mine.found.then(
        (salvage) => {
          if (underway !== mine) return;
          end("cancel");
          // What was found is of a scene that is no more.
          if (document.scene.peek() !== scene) return;
          if (salvage && salvage.keyframes.length > 0) show(salvage);
          else state.value = { kind: "helpless", salvage };
        },
        (error: unknown) => {
          if (underway !== mine) return;
          end("cancel");
          onProblem(error);
        },
      );
    },
    accept: () => end("commit"),
    discard: () => end("cancel"),
  };
}
