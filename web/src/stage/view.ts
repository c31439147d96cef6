import type { Signal } from "@preact/signals";

/** Which layers show. */
export interface Layers {
  readonly ties: boolean;
  readonly trails: boolean;
  readonly ghosts: boolean;
  readonly groups: boolean;
  readonly names: boolean;
}

/** Stage to screen: `screen = (x · scale + left, −y · scale + top)`, CSS pixels. */
export interface Camera {
  /** Pixels a meter. */
  readonly scale: number;
  /** Screen place of the stage's origin. */
  readonly left: number;
  readonly top: number;
}

/** How the person looks at the stage: never part of the scene nor of undo. */
export interface View {
  readonly camera: Signal<Camera>;
  readonly layers: Signal<Layers>;
  /** CSS pixels of the stage element. */
  readonly size: Signal<{ readonly width: number; readonly height: number }>;
  readonly hovered: Signal<number | null>;
  readonly theme: Signal<"light" | "dark" | "system">;
  /** 1 = the whole stage fits. */
  zoomBy(factor: number, at?: { readonly x: number; readonly y: number }): void;
  panBy(dx: number, dy: number): void;
  fit(): void;
}
