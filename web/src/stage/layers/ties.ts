import type { Frame } from "../frame";
import { fade } from "../spacing";
import type { TieBundle, TiePhase } from "../ties";

/** Below this alpha a hairline cannot be seen; stroking thousands of them would cost the frame. */
export const INVISIBLE = 0.032;

/** How far each phase shows, `t` of the way through the transition. */
export function presence(phase: TiePhase, t: number): number {
  switch (phase) {
    case "both":
      return 1;
    case "leaving":
      return 1 - t;
    case "coming":
      return t;
  }
}

/**
 * Ties as thin neutral lines, `t` of the way through the transition.
 *
 * Crowded ones give way; `always` says whose ties show at any spacing: everybody's, or those of the marked agents (1).
 */
export function drawTies(
  context: CanvasRenderingContext2D,
  frame: Frame,
  bundles: readonly TieBundle[],
  t: number,
  always: "all" | Uint8Array | null,
): void {
  const room = always === "all" ? 1 : fade(frame.spacing, 7, 20);
  const marked = always === "all" ? null : always;
  context.lineCap = "butt";
  context.strokeStyle = frame.palette.tie;
  for (let k = 0; k < bundles.length; k += 1) {
    const bundle = bundles[k];
    if (!bundle) continue;
    const alpha = bundle.alpha * presence(bundle.phase, t);
    if (alpha * room > INVISIBLE) strokeBundle(context, frame, bundle, alpha * room, null);
    if (marked && room < 1) strokeBundle(context, frame, bundle, alpha * (1 - room), marked);
  }
  context.globalAlpha = 1;
}

/** Pairs that are not tied any more, shown so that they can be tied again. */
export function drawCuts(
  context: CanvasRenderingContext2D,
  frame: Frame,
  cuts: readonly (readonly [a: number, b: number])[],
): void {
  context.lineWidth = 1;
  context.lineCap = "butt";
  context.strokeStyle = frame.palette.tie;
  context.globalAlpha = 0.4;
  context.setLineDash([3, 3]);
  context.beginPath();
  for (const [a, b] of cuts) line(context, frame, a, b);
  context.stroke();
  context.setLineDash([]);
  context.globalAlpha = 1;
}

function strokeBundle(
  context: CanvasRenderingContext2D,
  frame: Frame,
  { pairs, width }: TieBundle,
  alpha: number,
  only: Uint8Array | null,
): void {
  const { points, size } = frame;
  context.lineWidth = width;
  context.globalAlpha = alpha;
  context.beginPath();
  for (let k = 0; k + 1 < pairs.length; k += 2) {
    const a = pairs[k] ?? 0;
    const b = pairs[k + 1] ?? 0;
    if (only && only[a] !== 1 && only[b] !== 1) continue;
    const ax = points[2 * a] ?? 0;
    const ay = points[2 * a + 1] ?? 0;
    const bx = points[2 * b] ?? 0;
    const by = points[2 * b + 1] ?? 0;
    const isBeside = (ax < 0 && bx < 0) || (ax > size.width && bx > size.width);
    const isAbove = (ay < 0 && by < 0) || (ay > size.height && by > size.height);
    if (isBeside || isAbove) continue;
    context.moveTo(ax, ay);
    context.lineTo(bx, by);
  }
  context.stroke();
}

function line(context: CanvasRenderingContext2D, { points }: Frame, a: number, b: number): void {
  context.moveTo(points[2 * a] ?? 0, points[2 * a + 1] ?? 0);
  context.lineTo(points[2 * b] ?? 0, points[2 * b + 1] ?? 0);
}
