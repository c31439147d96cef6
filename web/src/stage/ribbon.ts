import { clamp, fade } from "./spacing";

/** How a trail looks at a spacing, all in CSS pixels. */
export interface TrailLook {
  /** Share of the transition that it reaches back. */
  readonly reach: number;
  readonly tailWidth: number;
  readonly headWidth: number;
  readonly headAlpha: number;
  /** Steps of alpha along it. */
  readonly steps: number;
  /** What each step is filled with; layered steps add up to the alpha at their middle. */
  readonly alphas: Float64Array;
  /** Pieces of a step, so that it bends. */
  readonly bends: number;
  /** Wide ribbons lay each step over all that follows, which leaves no seam; narrow ones lay the steps end to end. */
  readonly isLayered: boolean;
}

const TAIL_ALPHA = 0.03;
/** Past the middle a trail has firmed only so far. */
const KNEE = { at: 0.55, firmness: 0.42 } as const;

/** More ribbons than this are laid end to end, whatever their width. */
const FEW = 90;

/** The trail of discs of `radius` at a spacing: shorter and fainter in a crowd, slimmer where there is much room. */
export function trailLook(spacing: number, radius: number, trailAlpha: number, agentCount: number): TrailLook {
  const room = fade(spacing, 12, 14);
  const ease = fade(spacing, 36, 44);
  const isLayered = radius > 6 && agentCount <= FEW;
  const steps = isLayered ? 18 : 6;
  const headAlpha = trailAlpha * (0.62 + 0.38 * room) * (1 - 0.15 * ease);
  return {
    reach: 0.5 + 0.5 * room,
    tailWidth: Math.max(0.35, 0.14 * radius),
    headWidth: Math.max(0.9, (0.95 - 0.15 * ease) * radius),
    headAlpha,
    steps,
    alphas: Float64Array.from({ length: steps }, (_, step) => stepAlpha(step, steps, headAlpha, isLayered)),
    bends: isLayered || radius <= 4.5 ? 2 : 3,
    isLayered,
  };
}

/** Alpha of a trail at `t` from its tail (0) to its head (1). */
export function trailAlphaAt(t: number, headAlpha: number): number {
  const knee = TAIL_ALPHA + (headAlpha - TAIL_ALPHA) * KNEE.firmness;
  if (t <= KNEE.at) return TAIL_ALPHA + (knee - TAIL_ALPHA) * (t / KNEE.at);
  return knee + (headAlpha - knee) * ((clamp(t, 0, 1) - KNEE.at) / (1 - KNEE.at));
}

function stepAlpha(step: number, steps: number, headAlpha: number, isLayered: boolean): number {
  const here = trailAlphaAt((step + 0.5) / steps, headAlpha);
  if (!isLayered || step === 0) return here;
  const below = trailAlphaAt((step - 0.5) / steps, headAlpha);
  return 1 - (1 - here) / (1 - below);
}

/**
 * The outline of a tapered ribbon along a line of places.
 *
 * `line` has x, y a place in CSS pixels; `out` receives left x, y and right x, y a place, from `at` on.
 * Repeated places take the direction of their neighbors.
 */
export function outlineInto(
  line: Float32Array,
  count: number,
  tailWidth: number,
  headWidth: number,
  out: Float32Array,
  at: number,
): void {
  let nx = 0;
  let ny = 0;
  for (let place = 0; place < count; place += 1) {
    const before = 2 * Math.max(place - 1, 0);
    const after = 2 * Math.min(place + 1, count - 1);
    const dx = (line[after] ?? 0) - (line[before] ?? 0);
    const dy = (line[after + 1] ?? 0) - (line[before + 1] ?? 0);
    const length = Math.sqrt(dx * dx + dy * dy);
    if (length > 1e-3) {
      nx = -dy / length;
      ny = dx / length;
    }
    const half = (tailWidth + (headWidth - tailWidth) * (place / (count - 1))) / 2;
    const x = line[2 * place] ?? 0;
    const y = line[2 * place + 1] ?? 0;
    const k = at + 4 * place;
    out[k] = x + nx * half;
    out[k + 1] = y + ny * half;
    out[k + 2] = x - nx * half;
    out[k + 3] = y - ny * half;
  }
}
