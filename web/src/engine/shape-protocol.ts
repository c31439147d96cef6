import type { EngineProblem } from "./api";

/** A picture, how its shape is read, and what places are wanted in it. */
export interface ShapeRequest {
  /** Pixels in a row. */
  readonly width: number;
  /** Red, green, blue and opacity of each, from the top. */
  readonly rgba: Uint8ClampedArray;
  /** What is darker is the shape, 0.01..0.99; where something is transparent, what is more opaque than 1 minus it. */
  readonly threshold: number;
  readonly isInverted: boolean;
  /** Meters: the shape becomes as large as fits. */
  readonly room: readonly [width: number, depth: number];
  readonly count: number;
  /** Meters; 0 where it does not matter. */
  readonly leastDistance: number;
  readonly isOutline: boolean;
  readonly seed: number;
}

/** Page to worker: a newer request takes the place of the one under way. */
export interface ShapeQuestion {
  readonly id: number;
  readonly request: ShapeRequest;
}

/** Worker to page. */
export type ShapeAnswer =
  | { readonly kind: "progress"; readonly id: number /** 0..1 */; readonly progress: number }
  /** x, y each, about the origin; meters. */
  | { readonly kind: "slots"; readonly id: number; readonly xy: Float64Array }
  | { readonly kind: "refused"; readonly id: number; readonly problem: EngineProblem };
