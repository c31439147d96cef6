import type { Point } from "../../document/formation";
import type { ScreenPoint, Size } from "../camera";
import type { Orbit } from "./orbit";

/** Up and down, radians: a long lens, so that the far rows are not dwarfed. */
export const FIELD_OF_VIEW = 0.56;

/** What is this near to the eye or behind it is not on the screen, meters. */
const NEAREST = 1e-3;

/** How an orbit sees the stage on a screen. One is kept and refilled, so that a frame allocates nothing. */
export class Sight {
  /** The eye, stage meters. */
  readonly eye = new Float64Array(3);
  /** Unit vectors of the screen: to the right, up, and away from the eye. */
  readonly right = new Float64Array(3);
  readonly up = new Float64Array(3);
  readonly forward = new Float64Array(3);
  /** CSS pixels of what is one meter wide and one meter away. */
  focal = 1;
  private middleX = 0;
  private middleY = 0;

  look({ x, y, z, distance, azimuth, elevation }: Orbit, size: Size): void {
    const sin = Math.sin(azimuth);
    const cos = Math.cos(azimuth);
    const rise = Math.sin(elevation);
    const run = Math.cos(elevation);
    fill(this.right, cos, sin, 0);
    fill(this.up, -sin * rise, cos * rise, run);
    fill(this.forward, -sin * run, cos * run, -rise);
    fill(this.eye, x + distance * sin * run, y - distance * cos * run, z + distance * rise);
    this.focal = size.height / 2 / Math.tan(FIELD_OF_VIEW / 2);
    this.middleX = size.width / 2;
    this.middleY = size.height / 2;
  }

  /** Where a place is on the screen, CSS pixels, and how far from the eye, into `out` from `at` on; depth 0: behind it. */
  projectInto(x: number, y: number, z: number, out: Float32Array, at: number): void {
    const { eye, right, up, forward } = this;
    const dx = x - (eye[0] ?? 0);
    const dy = y - (eye[1] ?? 0);
    const dz = z - (eye[2] ?? 0);
    const depth = along(forward, dx, dy, dz);
    const isSeen = depth > NEAREST;
    const scale = isSeen ? this.focal / depth : 0;
    out[at] = this.middleX + along(right, dx, dy, dz) * scale;
    out[at + 1] = this.middleY - along(up, dx, dy, dz) * scale;
    out[at + 2] = isSeen ? depth : 0;
  }

  /** The place on the ground under a place of the screen; null above the horizon. */
  groundAt(at: ScreenPoint): Point | null {
    return this.levelAt(at, 0);
  }

  /** The place under a place of the screen, `height` meters above the ground; null where that plane is not seen from above. */
  levelAt(at: ScreenPoint, height: number): Point | null {
    const { eye, right, up, forward } = this;
    const across = (at.x - this.middleX) / this.focal;
    const over = (this.middleY - at.y) / this.focal;
    const ray = (axis: number) => (forward[axis] ?? 0) + across * (right[axis] ?? 0) + over * (up[axis] ?? 0);
    const fall = -ray(2);
    const above = (eye[2] ?? 0) - height;
    if (fall <= 1e-6 || above <= 0) return null;
    const reach = above / fall;
    return [(eye[0] ?? 0) + ray(0) * reach, (eye[1] ?? 0) + ray(1) * reach];
  }
}

function fill(vector: Float64Array, x: number, y: number, z: number): void {
  vector[0] = x;
  vector[1] = y;
  vector[2] = z;
}

function along(axis: Float64Array, x: number, y: number, z: number): number {
  return (axis[0] ?? 0) * x + (axis[1] ?? 0) * y + (axis[2] ?? 0) * z;
}
