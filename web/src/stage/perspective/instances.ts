import { DynamicDrawUsage, InstancedBufferAttribute } from "three";
import type { Limbs } from "./gait";

/** What the graphics card reads of every agent; all bodies and marks share it. */
export class Instances {
  /** x, y, z, meters. */
  readonly place: Float32Array;
  /** Unit vectors from the body: ahead, and to its left. */
  readonly ahead: Float32Array;
  readonly left: Float32Array;
  readonly limbs: Limbs;
  /** How much of them is to be seen, 0..1. */
  readonly presence: Float32Array;
  /** How large they are beside most. */
  readonly share: Float32Array;
  /** Red, green, blue as the screen takes them, 0..1. */
  readonly tint: Float32Array;
  /** 1 for who is selected, else 0. */
  private readonly chosen: Float32Array;
  /** By the shaders' names. */
  readonly attributes: Readonly<Record<string, InstancedBufferAttribute>>;
  private readonly moving: readonly InstancedBufferAttribute[];
  private readonly walking: readonly InstancedBufferAttribute[];
  private readonly sizes: InstancedBufferAttribute;
  private readonly tints: InstancedBufferAttribute;
  private readonly choices: InstancedBufferAttribute;

  constructor(readonly count: number) {
    this.place = new Float32Array(3 * count);
    this.ahead = new Float32Array(3 * count);
    this.left = new Float32Array(3 * count);
    this.presence = new Float32Array(count).fill(1);
    this.share = new Float32Array(count).fill(1);
    this.tint = new Float32Array(3 * count);
    this.chosen = new Float32Array(count);
    this.limbs = {
      leftLeg: new Float32Array(4 * count),
      rightLeg: new Float32Array(4 * count),
      leftArm: new Float32Array(4 * count),
      rightArm: new Float32Array(4 * count),
      posture: new Float32Array(3 * count),
    };
    const frame = {
      place: changing(this.place, 3),
      ahead: changing(this.ahead, 3),
      left: changing(this.left, 3),
      presence: changing(this.presence, 1),
    };
    const limbs = {
      leftLeg: changing(this.limbs.leftLeg, 4),
      rightLeg: changing(this.limbs.rightLeg, 4),
      leftArm: changing(this.limbs.leftArm, 4),
      rightArm: changing(this.limbs.rightArm, 4),
      posture: changing(this.limbs.posture, 3),
    };
    this.sizes = new InstancedBufferAttribute(this.share, 1);
    this.tints = new InstancedBufferAttribute(this.tint, 3);
    this.choices = new InstancedBufferAttribute(this.chosen, 1);
    this.moving = Object.values(frame);
    this.walking = Object.values(limbs);
    this.attributes = { ...frame, ...limbs, share: this.sizes, tint: this.tints, chosen: this.choices };
  }

  /** After places and directions were filled, and the limbs of who walks. */
  moved(isWalking: boolean): void {
    renew(this.moving);
    if (isWalking) renew(this.walking);
  }

  grow(shares: Float32Array): void {
    this.share.set(shares);
    this.sizes.needsUpdate = true;
  }

  paint(colors: readonly string[]): void {
    colors.forEach((color, agent) => {
      const value = Number.parseInt(color.slice(1), 16);
      this.tint[3 * agent] = (value >> 16) / 255;
      this.tint[3 * agent + 1] = ((value >> 8) & 255) / 255;
      this.tint[3 * agent + 2] = (value & 255) / 255;
    });
    this.tints.needsUpdate = true;
  }

  choose(agents: ReadonlySet<number>): void {
    this.chosen.fill(0);
    for (const agent of agents) if (agent < this.count) this.chosen[agent] = 1;
    this.choices.needsUpdate = true;
  }
}

/** By index: it is done every frame. */
function renew(attributes: readonly InstancedBufferAttribute[]): void {
  for (let k = 0; k < attributes.length; k += 1) {
    const attribute = attributes[k];
    if (attribute) attribute.needsUpdate = true;
  }
}

function changing(array: Float32Array, size: number): InstancedBufferAttribute {
  return new InstancedBufferAttribute(array, size).setUsage(DynamicDrawUsage);
}
