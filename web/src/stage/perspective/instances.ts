import { DynamicDrawUsage, InstancedBufferAttribute } from "three";

/** What the graphics card reads of every agent; all bodies and marks share it. */
export class Instances {
  /** x, y, z in meters and the heading in radians. */
  readonly place: Float32Array;
  /** Two numbers whose meaning is the body's: see its shader. */
  readonly attitude: Float32Array;
  /** Red, green, blue as the screen takes them, 0..1. */
  readonly tint: Float32Array;
  /** 1 for who is selected, else 0. */
  readonly chosen: Float32Array;
  readonly attributes: {
    readonly place: InstancedBufferAttribute;
    readonly attitude: InstancedBufferAttribute;
    readonly tint: InstancedBufferAttribute;
    readonly chosen: InstancedBufferAttribute;
  };

  constructor(readonly count: number) {
    this.place = new Float32Array(4 * count);
    this.attitude = new Float32Array(2 * count);
    this.tint = new Float32Array(3 * count);
    this.chosen = new Float32Array(count);
    this.attributes = {
      place: new InstancedBufferAttribute(this.place, 4).setUsage(DynamicDrawUsage),
      attitude: new InstancedBufferAttribute(this.attitude, 2).setUsage(DynamicDrawUsage),
      tint: new InstancedBufferAttribute(this.tint, 3),
      chosen: new InstancedBufferAttribute(this.chosen, 1),
    };
  }

  /** After `place` and `attitude` were filled. */
  moved(): void {
    this.attributes.place.needsUpdate = true;
    this.attributes.attitude.needsUpdate = true;
  }

  paint(colors: readonly string[]): void {
    colors.forEach((color, agent) => {
      const value = Number.parseInt(color.slice(1), 16);
      this.tint[3 * agent] = (value >> 16) / 255;
      this.tint[3 * agent + 1] = ((value >> 8) & 255) / 255;
      this.tint[3 * agent + 2] = (value & 255) / 255;
    });
    this.attributes.tint.needsUpdate = true;
  }

  choose(agents: ReadonlySet<number>): void {
    this.chosen.fill(0);
    for (const agent of agents) if (agent < this.count) this.chosen[agent] = 1;
    this.attributes.chosen.needsUpdate = true;
  }
}
