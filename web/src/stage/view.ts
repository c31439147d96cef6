import type { ReadonlySignal, Signal } from "@preact/signals";
import type { Bounds, Camera } from "./camera";

/** Which layers show. */
export interface Layers {
  readonly ties: boolean;
  readonly trails: boolean;
  readonly ghosts: boolean;
  readonly groups: boolean;
  readonly names: boolean;
}

/** What zooms and fits: the plan, or what is seen instead of it. */
export interface Lens {
  /** Zooms by a factor, about the middle unless told where (CSS pixels of the stage element). */
  zoomBy(factor: number, at?: { readonly x: number; readonly y: number }): void;
  /** Shows the whole show: the stage, or closer where the agents use little of it. */
  fit(): void;
}

/** From above, from the front, or from anywhere. */
export type Projection = "plan" | "front" | "perspective";

/** How the person looks at the stage: never part of the scene nor of undo. */
export interface View extends Lens {
  readonly camera: Signal<Camera>;
  readonly layers: Signal<Layers>;
  /** CSS pixels of the stage element. */
  readonly size: Signal<{ readonly width: number; readonly height: number }>;
  /** CSS pixels of it that a sheet lies over, from below. */
  readonly covered: Signal<number>;
  readonly hovered: Signal<number | null>;
  readonly theme: Signal<"light" | "dark" | "system">;
  /** What the timeline counts in. */
  readonly ruler: Signal<"seconds" | "counts">;
  /** How close: 1 when the whole stage just fits, 2 at twice that. */
  readonly zoom: ReadonlySignal<number>;
  /** What the person asked to see; the plan shows until the other is there. */
  readonly projection: Signal<Projection>;
  /** The perspective view while it covers the plan, which then rests. */
  readonly lens: Signal<Lens | null>;
  panBy(dx: number, dy: number): void;
  /** Fits what is within these bounds, until the whole show is asked for. */
  show(bounds: Bounds): void;
}
