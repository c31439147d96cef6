import type { Gesture } from "../../document/store";

/** How a press on a keyframe goes on. */
export type DragState =
  | { readonly kind: "idle" }
  | { readonly kind: "pressed"; readonly index: number; readonly x: number }
  | {
      readonly kind: "retiming";
      readonly index: number;
      readonly x: number;
      readonly gesture: Gesture;
      /** Where it was stopped although it was pulled further, scene seconds; null: it follows. */
      readonly stop: number | null;
    }
  /** Over another keyframe: letting go brings the formation to its place in the order. */
  | {
      readonly kind: "reordering";
      readonly index: number;
      readonly x: number;
      readonly gesture: Gesture;
      readonly other: number;
    };

export const IDLE: DragState = { kind: "idle" };
