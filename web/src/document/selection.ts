import type { GroupPath } from "./scene";

/** What the person points at. One thing at a time; never part of undo. */
export type Selection =
  | { readonly kind: "none" }
  | { readonly kind: "agents"; readonly agents: ReadonlySet<number> }
  | { readonly kind: "tie"; readonly a: number; readonly b: number }
  | { readonly kind: "group"; readonly path: GroupPath }
  /** With `anchor`: the run of keyframes between the two, `index` the end that moves. */
  | { readonly kind: "keyframe"; readonly index: number; readonly anchor?: number }
  | { readonly kind: "transition"; readonly index: number }
  | { readonly kind: "obstacle"; readonly index: number };

export const NOTHING: Selection = { kind: "none" };
