import type { ScreenPoint } from "../camera";

/** What hands can do to the perspective view. Places are CSS pixels of its element. */
export interface Steering {
  /** Around and up, radians. */
  turn(azimuth: number, elevation: number): void;
  /** What was under `from` goes to `to`. */
  slide(from: ScreenPoint, to: ScreenPoint): void;
  zoom(factor: number, at: ScreenPoint): void;
  hover(at: ScreenPoint | null, slack: number): void;
  pick(at: ScreenPoint, slack: number, way: "replace" | "add" | "toggle"): void;
}
