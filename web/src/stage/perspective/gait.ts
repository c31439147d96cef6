import { HEIGHTS } from "./figure";

/** A foot's way through a stride: how far in front of the hip, and how much its knee bends, 0 to 1. */
interface Footing {
  forward: number;
  lift: number;
}

/** How a knee, an elbow, an arm and the trunk follow the feet: radians for each unit of reach. */
const KNEE_BEND = 5;
const KNEE_RISE = 2.5;
const ELBOW_BEND = 2;
const ARM_SWING = 2.2;
const LEAN = 0.3;
/** No elbow is quite straight. Radians. */
const EASY_ELBOW = 0.15;

/** Of the two feet; refilled for every agent. */
const LEFT: Footing = { forward: 0, lift: 0 };
const RIGHT: Footing = { forward: 0, lift: 0 };

/** The limbs of all figures: one array a limb, four numbers an agent — cosine and sine of its upper and its lower part. */
export interface Limbs {
  readonly leftLeg: Float32Array;
  readonly rightLeg: Float32Array;
  readonly leftArm: Float32Array;
  readonly rightArm: Float32Array;
  /** Three numbers an agent: how far the hip comes down, as a share of the height, and cosine and sine of the lean. */
  readonly posture: Float32Array;
}

/**
 * Poses everybody's limbs after as many strides as their phase, each foot reaching `reaches` heights in front at most.
 *
 * A stride is four reaches long. A foot on the ground stays where it is while the body goes on; at phase 0 and
 * reach 0 the figure stands. Angles are about the axis to the left: positive is forward for what hangs down.
 *
 * All at once: fractions handed over one by one would be boxed, for every agent and frame.
 */
export function gaitsInto(phases: Float64Array, reaches: Float64Array, limbs: Limbs): void {
  for (let agent = 0; agent < phases.length; agent += 1)
    gaitInto(phases[agent] ?? 0, reaches[agent] ?? 0, limbs, agent);
}

function gaitInto(phase: number, reach: number, limbs: Limbs, agent: number): void {
  footingInto(phase, reach, LEFT);
  footingInto(phase + 0.5, reach, RIGHT);
  const stride = 2 * Math.PI * phase;
  legInto(LEFT, reach, limbs.leftLeg, 4 * agent);
  legInto(RIGHT, reach, limbs.rightLeg, 4 * agent);
  armInto(Math.sin(stride) * reach, reach, limbs.leftArm, 4 * agent);
  armInto(-Math.sin(stride) * reach, reach, limbs.rightArm, 4 * agent);
  // The leg that stands carries the hip along an arc.
  const stance = LEFT.lift > 0 ? RIGHT.forward : LEFT.forward;
  const { posture } = limbs;
  posture[3 * agent] = HEIGHTS.hip - Math.sqrt(HEIGHTS.hip ** 2 - stance ** 2);
  posture[3 * agent + 1] = Math.cos(LEAN * reach);
  posture[3 * agent + 2] = -Math.sin(LEAN * reach);
}

/** Half a stride on the ground, from the front to the rear, and half of it swinging through. */
function footingInto(phase: number, reach: number, out: Footing): void {
  const turn = phase + 0.25 - Math.floor(phase + 0.25);
  const swing = 2 * Math.PI * (turn - 0.5);
  const isStanding = turn < 0.5;
  out.forward = isStanding ? reach * (1 - 4 * turn) : -reach * Math.cos(swing);
  out.lift = isStanding ? 0 : Math.sin(swing);
}

function legInto({ forward, lift }: Footing, reach: number, out: Float32Array, at: number): void {
  const thigh = Math.asin(forward / HEIGHTS.hip) + KNEE_RISE * reach * lift;
  turnInto(thigh, thigh - KNEE_BEND * reach * lift, out, at);
}

function armInto(swing: number, reach: number, out: Float32Array, at: number): void {
  turnInto(ARM_SWING * swing, ARM_SWING * swing + EASY_ELBOW + ELBOW_BEND * reach, out, at);
}

function turnInto(upper: number, lower: number, out: Float32Array, at: number): void {
  out[at] = Math.cos(upper);
  out[at + 1] = Math.sin(upper);
  out[at + 2] = Math.cos(lower);
  out[at + 3] = Math.sin(lower);
}
