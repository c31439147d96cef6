/** What moves as a whole, but for its knee or elbow; the shader knows the same numbers. */
export const LIMB = { trunk: 0, leftLeg: 1, rightLeg: 2, leftArm: 3, rightArm: 4 } as const;

/** Where limbs turn, as shares of the figure's height. The hip is also the length of a leg. */
export const HEIGHTS = { hip: 0.5, knee: 0.275, shoulder: 0.785, elbow: 0.635 } as const;

/** Triangles of a walking figure: 1 high, feet on the ground, facing along x, its left along y. */
export interface FigureShape {
  /** x, y, z a corner. */
  readonly corners: Float32Array;
  /** Which limb, and 1 below its knee or elbow, else 0: two numbers a corner. */
  readonly parts: Float32Array;
  /** Three corners a triangle, counterclockwise from outside. */
  readonly triangles: Uint16Array;
}

/** An ellipse across a limb: its height, how far forward its middle is, half its depth and half its breadth. */
type Ring = readonly [z: number, forward: number, depth: number, breadth: number];

// From the ground up. Ends inside another limb stay open.
const TRUNK: readonly Ring[] = [
  [0.45, 0, 0, 0],
  [0.475, 0, 0.058, 0.076],
  [0.52, 0, 0.063, 0.088],
  [0.6, 0, 0.05, 0.074],
  [0.73, 0.004, 0.064, 0.1],
  [0.795, 0, 0.048, 0.104],
  [0.835, 0.002, 0.026, 0.034],
  [0.885, 0.004, 0.024, 0.026],
];
const HEAD: readonly Ring[] = [
  [0.866, 0.012, 0, 0],
  [0.89, 0.01, 0.046, 0.038],
  [0.935, 0.004, 0.057, 0.047],
  [0.975, 0, 0.046, 0.039],
  [1, 0, 0, 0],
];
const THIGH: readonly Ring[] = [
  [0.265, 0.002, 0.033, 0.032],
  [0.38, 0.002, 0.047, 0.043],
  [0.47, 0, 0.056, 0.048],
  [0.54, 0, 0.044, 0.036],
];
const SHIN: readonly Ring[] = [
  [0.04, 0, 0.02, 0.02],
  [0.2, -0.004, 0.037, 0.034],
  [0.29, 0.002, 0.031, 0.03],
];
const FOOT: readonly Ring[] = [
  [0, 0.034, 0, 0],
  [0, 0.034, 0.07, 0.031],
  [0.034, 0.026, 0.054, 0.028],
  [0.062, 0.002, 0, 0],
];
const UPPER_ARM: readonly Ring[] = [
  [0.625, 0, 0.024, 0.022],
  [0.77, 0, 0.036, 0.031],
  [0.808, 0, 0.028, 0.025],
  [0.822, 0, 0, 0],
];
const FOREARM: readonly Ring[] = [
  [0.4, 0.004, 0, 0],
  [0.44, 0.004, 0.021, 0.014],
  [0.49, 0.002, 0.016, 0.015],
  [0.645, 0, 0.024, 0.022],
];

const HIP_OUT = 0.046;
const SHOULDER_OUT = 0.114;

interface Growing {
  readonly corners: number[];
  readonly parts: number[];
  readonly triangles: number[];
}

/** The figure with `around` corners to a ring: four will do in a crowd, more look round from near by. */
export function figureShape(around: number): FigureShape {
  const shape: Growing = { corners: [], parts: [], triangles: [] };
  const add = (limb: number, below: 0 | 1, out: number, ...tubes: (readonly Ring[])[]) => {
    for (const rings of tubes) addTube(shape, rings, around, out, [limb, below]);
  };
  add(LIMB.trunk, 0, 0, TRUNK, HEAD);
  for (const [side, leg, arm] of [
    [1, LIMB.leftLeg, LIMB.leftArm],
    [-1, LIMB.rightLeg, LIMB.rightArm],
  ] as const) {
    add(leg, 0, side * HIP_OUT, THIGH);
    add(leg, 1, side * HIP_OUT, SHIN, FOOT);
    add(arm, 0, side * SHOULDER_OUT, UPPER_ARM);
    add(arm, 1, side * SHOULDER_OUT, FOREARM);
  }
  return {
    corners: Float32Array.from(shape.corners),
    parts: Float32Array.from(shape.parts),
    triangles: Uint16Array.from(shape.triangles),
  };
}

/** A skin around rings from below; a ring without breadth closes it. */
function addTube(
  shape: Growing,
  rings: readonly Ring[],
  around: number,
  out: number,
  part: readonly [limb: number, below: 0 | 1],
): void {
  const first = shape.parts.length / 2;
  rings.forEach(([z, forward, depth, breadth], ring) => {
    const isPoint = breadth === 0;
    const isPointAbove = rings[ring + 1]?.[3] === 0;
    for (let k = 0; k < around; k += 1) {
      const angle = (2 * Math.PI * k) / around;
      shape.corners.push(forward + depth * Math.cos(angle), out + breadth * Math.sin(angle), z);
      shape.parts.push(...part);
      if (ring + 1 === rings.length) continue;
      const here = first + ring * around;
      const above = here + around;
      const next = (k + 1) % around;
      if (!isPoint) shape.triangles.push(here + k, here + next, above + k);
      if (!isPointAbove) shape.triangles.push(here + next, above + next, above + k);
    }
  });
}
