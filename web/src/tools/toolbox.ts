import type { ReadonlySignal, Signal } from "@preact/signals";
import type { Point } from "../document/formation";
import type { ObstacleShape } from "../document/scene";
import type { ShapeName as Shapes } from "../shapes/shape";
import type { Spacing as Spacings } from "../shapes/spacing";

export type ToolName = "select" | "draw" | "shape" | "tie" | "group" | "obstacle" | "pan";
export type ShapeName = Shapes;
export type Spacing = Spacings;

/** What the handles layer draws for the tool at work, in stage meters. */
export type Overlay =
  | { readonly kind: "none" }
  | { readonly kind: "marquee"; readonly from: Point; readonly to: Point }
  | {
      readonly kind: "stroke";
      readonly stroke: readonly Point[];
      readonly isClosed: boolean;
      readonly places: readonly Point[];
    }
  | { readonly kind: "shape"; readonly places: readonly Point[]; readonly outline: readonly Point[] }
  /** An obstacle under way; `next` is where a polygon's next corner would be. */
  | { readonly kind: "outline"; readonly shape: ObstacleShape; readonly next: Point | null }
  | { readonly kind: "tie"; readonly from: number; readonly to: Point; readonly target: number | null }
  | {
      readonly kind: "guides";
      readonly lines: readonly { readonly from: Point; readonly to: Point; readonly gap: string | null }[];
      /** How high what is moved is, where up is height. */
      readonly height: { readonly at: Point; readonly words: string } | null;
    }
  /** The handle to lift, under the pointer or pulled up by so many meters, and how high the agents are. */
  | { readonly kind: "lift"; readonly by: number; readonly words: string };

/** The tool in hand and its settings. */
export interface Toolbox {
  readonly active: Signal<ToolName>;
  readonly shape: Signal<ShapeName>;
  readonly spacing: Signal<Spacing>;
  /** Where the Tie tool's ties hold: throughout the show, or at the edited keyframe only. */
  readonly tieScope: Signal<"scene" | "keyframe">;
  readonly overlay: ReadonlySignal<Overlay>;
  /** CSS cursor of the stage. */
  readonly cursor: ReadonlySignal<string>;
  /** Puts what the tool in hand makes into the middle of what is seen, or ends what it is making: for hands without a pointer. */
  placeInMiddle(): void;
  /** Puts agents on places that are given about the middle of what is seen. */
  placeInView(places: readonly Point[], label: string): void;
}
