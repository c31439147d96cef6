import type { Camera, Size } from "./camera";
import type { Cast } from "./cast";
import type { Palette } from "./palette";
import { discRadius, screenSpacing } from "./spacing";

/** What every drawing function reads; one is kept and refilled, so that a frame allocates nothing. */
export class Frame {
  camera: Camera = { scale: 1, left: 0, top: 0 };
  size: Size = { width: 0, height: 0 };
  /** Canvas pixels a CSS pixel. */
  density = 1;
  /** `s`: CSS pixels between neighbors. Decides every detail. */
  spacing = 0;
  /** Of an agent's disc, CSS pixels. */
  radius = 0;
  /** Meters: x, y an agent, now. */
  places: Float32Array<ArrayBufferLike> = new Float32Array(0);
  /** Meters: how high each agent is, now; null where the show is on the plane. */
  heights: Float32Array<ArrayBufferLike> | null = null;
  /** By agent, 1 for who is not there now; null while everybody is. */
  isGone: Uint8Array | null = null;
  /** By agent, how much of it is to be seen, 0 nothing to 1 all; null while all of everybody is. */
  presence: Float32Array | null = null;
  /** CSS pixels on the stage: x, y an agent, now. */
  points: Float32Array<ArrayBufferLike> = new Float32Array(0);

  constructor(
    public palette: Palette,
    public cast: Cast,
  ) {}

  get agentCount(): number {
    return this.points.length / 2;
  }

  /** Takes a camera and the show's spacing in meters. */
  look(camera: Camera, size: Size, density: number, spacing: number): void {
    this.camera = camera;
    this.size = size;
    this.density = density;
    this.spacing = screenSpacing(spacing, camera.scale);
    this.radius = discRadius(this.spacing);
  }

  /** Makes room for `agentCount` agents, and their heights. */
  resize(agentCount: number, hasHeights: boolean): void {
    if (!hasHeights) this.heights = null;
    else if (this.heights?.length !== agentCount) this.heights = new Float32Array(agentCount);
    if (this.points.length === 2 * agentCount) return;
    this.places = new Float32Array(2 * agentCount);
    this.points = new Float32Array(2 * agentCount);
  }

  /** Takes who is not there. */
  miss(absent: readonly number[]): void {
    if (absent.length === 0) {
      this.isGone = null;
      return;
    }
    if (this.isGone?.length !== this.agentCount) this.isGone = new Uint8Array(this.agentCount);
    this.isGone.fill(0);
    for (const agent of absent) this.isGone[agent] = 1;
  }

  /** Makes room for how much of everybody is to be seen. */
  appear(): Float32Array {
    if (this.presence?.length !== this.agentCount) this.presence = new Float32Array(this.agentCount);
    return this.presence;
  }

  /** Projects `places` to `points`. */
  project(): void {
    const { camera, places, points } = this;
    for (let k = 0; k < points.length; k += 2) {
      points[k] = (places[k] ?? 0) * camera.scale + camera.left;
      points[k + 1] = camera.top - (places[k + 1] ?? 0) * camera.scale;
    }
  }

  screenX(x: number): number {
    return x * this.camera.scale + this.camera.left;
  }

  screenY(y: number): number {
    return this.camera.top - y * this.camera.scale;
  }

  /** Whether something within `reach` pixels of a place on the screen can be seen. */
  sees(x: number, y: number, reach: number): boolean {
    return x > -reach && y > -reach && x < this.size.width + reach && y < this.size.height + reach;
  }
}
