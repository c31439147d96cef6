import type { ReadonlySignal, Signal } from "@preact/signals";
import type { Scene } from "./scene";
import type { Selection } from "./selection";

/** A change of the scene with the words a person reads beside Undo. Pure. */
export interface Command {
  readonly label: string;
  /** Steps of the same series that follow one another are one undo entry: presses of an arrow key. */
  readonly series?: string;
  apply(scene: Scene): Scene;
}

/** A change under way: previews start from the scene where the gesture began, and end as one undo entry or none. */
export interface Gesture {
  preview(command: Command): void;
  commit(): void;
  cancel(): void;
}

/** The scene with its history. The only place where the scene changes. */
export interface DocumentStore {
  readonly scene: ReadonlySignal<Scene>;
  /** The scene without what a gesture under way previews: what is kept, saved and shared. */
  readonly accepted: ReadonlySignal<Scene>;
  /** What undo would take back, in words; null when there is nothing. */
  readonly undoLabel: ReadonlySignal<string | null>;
  readonly redoLabel: ReadonlySignal<string | null>;
  /** True while a gesture previews. */
  readonly isDragging: ReadonlySignal<boolean>;
  readonly selection: Signal<Selection>;
  /** The keyframe the person edits; follows the selection and the playhead. */
  readonly activeKeyframe: Signal<number>;
  /** Begin with another scene as if the page had opened with it: nothing to undo. */
  start(scene: Scene): void;
  perform(command: Command): void;
  beginGesture(): Gesture;
  undo(): void;
  redo(): void;
}
