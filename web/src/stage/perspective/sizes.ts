import type { Track } from "../../document/scene";
import { boundsOf } from "../camera";
import { clamp, neighborSpacing } from "../spacing";

/** Of the bodies in the perspective view, meters. */
export interface BodySizes {
  /** Radius of most discs. */
  readonly disc: number;
  /** How tall most figures are, and the tallest. */
  readonly figure: number;
  readonly tallest: number;
  /** By agent, how large it is beside most. */
  readonly shares: Float32Array;
}

/** A person of the engine's default body radius, meters. */
const PERSON = { radius: 0.25, height: 1.75 } as const;

/** A disc takes this much of the room to its neighbor, as on the plan; a figure is no taller than this much of it. */
const DISC_SHARE = 0.31;
const FIGURE_SHARE = 1.4;

/** In a wide formation bodies are larger than life, so that they are seen, but this much of it at most. */
const LARGEST = { disc: 1 / 60, flyer: 1 / 32, figure: 1 / 16 } as const;

/** Who is larger than most is drawn larger, but takes no more of the room to a neighbor than this, unless it truly does. */
const ROOM_SHARE = 0.5;
/** Nobody is too small to be seen beside the others. */
const LEAST_SHARE = 0.2;

/** As large as people are; larger where there is room for it. Everybody's stays the same for the whole show. */
export function bodySizes(track: Track): BodySizes {
  let extent = 0;
  let spacing = Number.POSITIVE_INFINITY;
  for (const { positions } of track.keyframes) {
    const bounds = boundsOf(positions.xy);
    if (bounds) extent = Math.max(extent, bounds.maxX - bounds.minX, bounds.maxY - bounds.minY);
    spacing = Math.min(spacing, neighborSpacing(positions));
  }
  const radii = Float64Array.from(track.agents, ({ radius }) => radius);
  const most = radii.toSorted()[(radii.length - 1) >> 1] ?? PERSON.radius;
  const isFlying = track.keyframes.some(({ positions }) => positions.heights !== null);
  const widest = (isFlying ? LARGEST.flyer : LARGEST.disc) * extent;
  const room = Number.isFinite(spacing) ? spacing : 0;
  const height = (PERSON.height * most) / PERSON.radius;
  const disc = Math.max(most, clamp(DISC_SHARE * room, 0, widest));
  const figure = Math.max(height, clamp(FIGURE_SHARE * room, 0, LARGEST.figure * extent));
  const seen = (radius: number) => Math.max(radius, Math.min((radius * disc) / most, ROOM_SHARE * room));
  const shares = Float32Array.from(radii, (radius) => Math.max(LEAST_SHARE, seen(radius) / disc));
  return { disc, figure, tallest: figure * shares.reduce((a, b) => Math.max(a, b), 1), shares };
}
