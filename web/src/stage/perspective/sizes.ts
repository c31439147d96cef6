import type { Track } from "../../document/scene";
import { boundsOf } from "../camera";
import { clamp, neighborSpacing } from "../spacing";

/** Of the bodies in the perspective view, meters. */
export interface BodySizes {
  /** Radius of a disc. */
  readonly disc: number;
  /** How tall a figure is. */
  readonly figure: number;
}

/** A person of the engine's default body radius, meters. */
const PERSON = { radius: 0.25, height: 1.75 } as const;

/** A disc takes this much of the room to its neighbor, as on the plan; a figure is no taller than this much of it. */
const DISC_SHARE = 0.31;
const FIGURE_SHARE = 1.4;

/** In a wide formation bodies are larger than life, so that they are seen, but this much of it at most. */
const LARGEST = { disc: 1 / 60, flyer: 1 / 32, figure: 1 / 16 } as const;

/** As large as people are; larger where there is room for it. One size for the whole show. */
export function bodySizes(track: Track): BodySizes {
  let extent = 0;
  let spacing = Number.POSITIVE_INFINITY;
  let radius = 0;
  for (const { positions } of track.keyframes) {
    const bounds = boundsOf(positions.xy);
    if (bounds) extent = Math.max(extent, bounds.maxX - bounds.minX, bounds.maxY - bounds.minY);
    spacing = Math.min(spacing, neighborSpacing(positions));
  }
  for (const agent of track.agents) radius = Math.max(radius, agent.radius);
  const body = radius || PERSON.radius;
  const isFlying = track.keyframes.some(({ positions }) => positions.heights !== null);
  const widest = (isFlying ? LARGEST.flyer : LARGEST.disc) * extent;
  const room = Number.isFinite(spacing) ? spacing : 0;
  const height = (PERSON.height * body) / PERSON.radius;
  return {
    disc: Math.max(body, clamp(DISC_SHARE * room, 0, widest)),
    figure: Math.max(height, clamp(FIGURE_SHARE * room, 0, LARGEST.figure * extent)),
  };
}
